// Files in memory, in one folder: what the library's readers and writers ask of a system. Emscripten's
// own file system has devices, links and folders, too, and weighs ten times as much. What emscripten
// 3.1.6 makes of this file loses the patterns of destructuring.
mergeInto(LibraryManager.library, {
  $memoryFiles__postset: 'memoryFiles.files = new Map();',
  $memoryFiles: {
    files: null,  // what is in a file, by its name
    opened: [],   // by number of the descriptor
    // Names are those in the folder; the folder itself is ''.
    name: (path) => UTF8ToString(path).replace(/^\.?\/+/, '').replace(/^\.$/, ''),
    file: (path) => memoryFiles.files.get(memoryFiles.name(path)),

    open: function(path, flags) {
      const name = memoryFiles.name(path);
      if (flags & {{{ cDefine('O_DIRECTORY') }}}) return -{{{ cDefine('EINVAL') }}};
      if (name === '') return -{{{ cDefine('EISDIR') }}};
      let file = memoryFiles.files.get(name);
      if (!file) {
        if (!(flags & {{{ cDefine('O_CREAT') }}}) || name.includes('/')) return -{{{ cDefine('ENOENT') }}};
        file = { bytes: new Uint8Array(1024), size: 0 };
        memoryFiles.files.set(name, file);
      } else if (flags & {{{ cDefine('O_EXCL') }}}) {
        return -{{{ cDefine('EEXIST') }}};
      }
      if (flags & {{{ cDefine('O_TRUNC') }}}) file.size = 0;
      let descriptor = 3;  // behind standard input, output and errors
      while (memoryFiles.opened[descriptor]) ++descriptor;
      memoryFiles.opened[descriptor] = { file, position: 0 };
      return descriptor;
    },
    status: function(path, result) {
      const file = memoryFiles.file(path), name = memoryFiles.name(path);
      if (!file && name !== '') return -{{{ cDefine('ENOENT') }}};
      HEAPU8.fill(0, result, result + {{{ C_STRUCTS.stat.__size__ }}});
      const kind = file ? {{{ cDefine('S_IFREG') }}} : {{{ cDefine('S_IFDIR') }}};
      {{{ makeSetValue('result', C_STRUCTS.stat.st_mode, "kind | 511", 'i32') }}};
      {{{ makeSetValue('result', C_STRUCTS.stat.st_nlink, '1', 'i32') }}};
      {{{ makeSetValue('result', C_STRUCTS.stat.st_size, 'file ? file.size : 0', 'i32') }}};
      return 0;
    },
    // Calls `take` with each piece of memory until one is not used to its end.
    pass: function(pieces, count, total, take) {
      let passed = 0;
      for (let i = 0; i < count; ++i, pieces += {{{ C_STRUCTS.iovec.__size__ }}}) {
        const begin = {{{ makeGetValue('pieces', C_STRUCTS.iovec.iov_base, 'i32') }}} >>> 0;
        const size = {{{ makeGetValue('pieces', C_STRUCTS.iovec.iov_len, 'i32') }}} >>> 0;
        const used = take(begin, size);
        passed += used;
        if (used < size) break;
      }
      {{{ makeSetValue('total', 0, 'passed', 'i32') }}};
      return 0;
    },
    write: function(open, begin, size) {
      const file = open.file, position = open.position, end = position + size;
      if (end > file.bytes.length) {
        const larger = new Uint8Array(Math.max(end, 2 * file.bytes.length));
        larger.set(file.bytes.subarray(0, file.size));
        file.bytes = larger;
      }
      file.bytes.set(HEAPU8.subarray(begin, begin + size), position);
      open.position = end;
      file.size = Math.max(file.size, end);
      return size;
    },
    read: function(open, begin, size) {
      const file = open.file, position = open.position;
      const part = file.bytes.subarray(position, Math.max(position, Math.min(file.size, position + size)));
      HEAPU8.set(part, begin);
      open.position += part.length;
      return part.length;
    },
  },

  __syscall_open__deps: ['$memoryFiles'],
  __syscall_open: function(path, flags) {
    return memoryFiles.open(path, flags);
  },
  __syscall_stat64__deps: ['$memoryFiles'],
  __syscall_stat64: function(path, result) {
    return memoryFiles.status(path, result);
  },
  __syscall_lstat64__deps: ['$memoryFiles'],
  __syscall_lstat64: function(path, result) {
    return memoryFiles.status(path, result);
  },
  __syscall_fstatat64__deps: ['$memoryFiles'],
  __syscall_fstatat64: function(folder, path, result) {
    return memoryFiles.status(path, result);
  },
  __syscall_access__deps: ['$memoryFiles'],
  __syscall_access: function(path) {
    return memoryFiles.file(path) || memoryFiles.name(path) === '' ? 0 : -{{{ cDefine('ENOENT') }}};
  },
  __syscall_unlink__deps: ['$memoryFiles'],
  __syscall_unlink: function(path) {
    return memoryFiles.files.delete(memoryFiles.name(path)) ? 0 : -{{{ cDefine('ENOENT') }}};
  },
  __syscall_rmdir: function() {
    return -{{{ cDefine('ENOTDIR') }}};
  },
  __syscall_rename__deps: ['$memoryFiles'],
  __syscall_rename: function(from, to) {
    const file = memoryFiles.file(from);
    if (!file) return -{{{ cDefine('ENOENT') }}};
    memoryFiles.files.delete(memoryFiles.name(from));
    memoryFiles.files.set(memoryFiles.name(to), file);
    return 0;
  },
  // Nothing is a link, and files belong to nobody.
  __syscall_readlink: function() {
    return -{{{ cDefine('EINVAL') }}};
  },
  __syscall_linkat: function() {
    return -{{{ cDefine('EPERM') }}};
  },
  __syscall_chmod: function() {
    return 0;
  },
  __syscall_fchmod: function() {
    return 0;
  },
  __syscall_chown32: function() {
    return 0;
  },
  __syscall_fchown32: function() {
    return 0;
  },
  __syscall_fcntl64: function() {
    return 0;
  },
  __syscall_ioctl: function() {
    return -{{{ cDefine('ENOTTY') }}};
  },

  fd_close__deps: ['$memoryFiles'],
  fd_close: function(descriptor) {
    delete memoryFiles.opened[descriptor];
    return 0;
  },
  fd_read__deps: ['$memoryFiles'],
  fd_read: function(descriptor, pieces, count, total) {
    const open = memoryFiles.opened[descriptor];
    if (!open) return {{{ cDefine('EBADF') }}};
    return memoryFiles.pass(pieces, count, total, (begin, size) => memoryFiles.read(open, begin, size));
  },
  fd_write__deps: ['$memoryFiles'],
  fd_write: function(descriptor, pieces, count, total) {
    const open = memoryFiles.opened[descriptor];
    if (!open && descriptor > 2) return {{{ cDefine('EBADF') }}};
    return memoryFiles.pass(pieces, count, total, (begin, size) => {
      if (open) return memoryFiles.write(open, begin, size);
      if (size > 0) err(UTF8ArrayToString(HEAPU8, begin, size));
      return size;
    });
  },
  fd_seek__deps: ['$memoryFiles'],
  fd_seek: function(descriptor, low, high, whence, result) {
    const open = memoryFiles.opened[descriptor];
    if (!open) return {{{ cDefine('ESPIPE') }}};
    const from = [0, open.position, open.file.size][whence];
    const position = from + high * 4294967296 + (low >>> 0);
    if (position < 0) return {{{ cDefine('EINVAL') }}};
    open.position = position;
    {{{ makeSetValue('result', 0, 'position', 'i32') }}};
    {{{ makeSetValue('result', 4, '0', 'i32') }}};
    return 0;
  },
  fd_fdstat_get: function() {
    return {{{ cDefine('EBADF') }}};
  },
});
