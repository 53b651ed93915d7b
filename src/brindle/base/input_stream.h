#pragma once
#include "brindle/base/input_file.h"
