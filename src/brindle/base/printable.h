#pragma once
#include "brindle/base/text.h"
