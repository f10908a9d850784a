#ifndef CLEFT_H
#define CLEFT_H
#include "cleft/cleft_status.h"
#endif
