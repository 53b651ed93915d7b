#pragma once
#include "brindle/base/standard.h"
