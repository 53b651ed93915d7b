#pragma once
#include "brindle/base/elementary.h"
