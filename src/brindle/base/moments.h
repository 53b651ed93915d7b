#pragma once
#include "brindle/base/parallel.h"
