#pragma once
#include "brindle/base/output_file.h"
