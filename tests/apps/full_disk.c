/* write(2) as on a disk that is full after FULL_DISK_WRITES writes to regular files below FULL_DISK_FOLDER. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int is_below(int descriptor, const char *folder) {
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t size = readlink(link, path, sizeof path - 1);
  if (size <= 0) return 0;
  path[size] = '\0';
  const size_t length = strlen(folder);
  return strncmp(path, folder, length) == 0 && path[length] == '/' && strstr(path + length + 1, "/") != NULL;
}

ssize_t write(int descriptor, const void *bytes, size_t size) {
  static atomic_int written;
  static ssize_t (*true_write)(int, const void *, size_t);
  if (true_write == NULL) *(void **)&true_write = dlsym(RTLD_NEXT, "write");
  const char *folder = getenv("FULL_DISK_FOLDER"), *room = getenv("FULL_DISK_WRITES");
  if (folder != NULL && room != NULL && is_below(descriptor, folder) && atomic_fetch_add(&written, 1) >= atoi(room)) {
    errno = ENOSPC;
    return -1;
  }
  return true_write(descriptor, bytes, size);
}
