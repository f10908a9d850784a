/* A folder of its own and a context for each test of files. */
#ifndef FOLDER_H
#define FOLDER_H

#include "cleft/cleft_io.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { FOLDER_NAME = 64 };

/* 0 if both are there. */
static inline int make_folder(char folder[FOLDER_NAME], cleft_context** context)
{
    strcpy(folder, "/tmp/cleft_io_XXXXXX");
    return mkdtemp(folder) && cleft_context_create(context) == CLEFT_OK ? 0 : -1;
}

/* With all that is in it; 0 if it is gone. */
static inline int remove_folder(const char* folder)
{
    char command[2 * FOLDER_NAME];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command);
}

#endif
