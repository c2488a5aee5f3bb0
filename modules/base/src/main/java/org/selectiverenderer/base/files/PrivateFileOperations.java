package org.selectiverenderer.base.files;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Operations that create files and folders as {@link PrivateFiles} does.
 *
 * @param unlinked whether a symbolic link is refused, rather than its target written
 */
record PrivateFileOperations(boolean unlinked) implements FileOperations {
  @Override
  public Path target(Path file) throws IOException {
    if (unlinked && Files.isSymbolicLink(file)) {
      throw new IOException("it is a link to " + Files.readSymbolicLink(file));
    }
    return FileOperations.super.target(file);
  }

  @Override
  public void createFolder(Path folder) throws IOException {
    Files.createDirectory(folder, PrivateFiles.attributes(folder, "rwx------"));
  }

  @Override
  public void write(Path file, byte[] content) throws IOException {
    try (FileChannel channel =
        PrivateFiles.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE)) {
      DiskSync.write(channel, content);
      channel.force(true);
    }
  }
}
