package org.selectiverenderer.authoring.packaging;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleConsumer;

/**
 * Copies the files of a package into a folder, all or none. Their contents, of any size, are first
 * written to a folder of their own in it; when all are on the disk, each is moved to its place. If
 * anything fails, or the work is cancelled, what was added is removed and what was replaced is
 * restored; {@link WrittenFiles} can do the same later.
 */
final class FolderTransaction {
  private static final int CHUNK = 1 << 20;

  private final Path folder;
  private final DoubleConsumer progress;
  private final WrittenFiles log = new WrittenFiles();
  private long written;

  /** A file with its place, where its content is until then, and where what it replaces goes. */
  private record Staged(Path place, Path content, Optional<Path> replaced) {}

  /**
   * @param folder the target folder; it is created
   * @param progress receives the share that is done, and may throw to end the work
   */
  FolderTransaction(Path folder, DoubleConsumer progress) {
    this.folder = folder;
    this.progress = progress;
  }

  WrittenFiles write(List<PackagedFile> files) throws IOException {
    try {
      createFolders(folder.toAbsolutePath().normalize());
      Path real = folder.toRealPath();
      PackageWriter.keepSources(files, real);
      for (Staged file : staged(files, real, log.stage(real))) {
        log.exchange(file.content(), file.place(), file.replaced());
      }
      return log.complete();
    } catch (IOException | RuntimeException | Error e) {
      log.withdrawBecause(e);
      throw e;
    }
  }

  private List<Staged> staged(List<PackagedFile> files, Path real, Path stage) throws IOException {
    long all = 1;
    for (PackagedFile file : files) {
      all += file.size();
    }
    List<Staged> staged = new ArrayList<>();
    for (PackagedFile file : files) {
      Path place = real.resolve(file.target()).normalize();
      if (!place.startsWith(real)) {
        throw outside(place);
      }
      createParents(place, real);
      boolean there = Files.exists(place, LinkOption.NOFOLLOW_LINKS);
      if (there && Files.isDirectory(place, LinkOption.NOFOLLOW_LINKS)) {
        throw new IOException(place + ": is a folder, and is not replaced by a file");
      }
      if (!there || !PackageWriter.same(file, place)) {
        Path content = stage.resolve("new-" + staged.size());
        Optional<Path> replaced =
            there
                ? Optional.of(WrittenFiles.former(stage, real.relativize(place)))
                : Optional.empty();
        copy(file, content, all);
        staged.add(new Staged(place, content, replaced));
      } else {
        written += file.size();
      }
      progress.accept((double) written / all);
    }
    return staged;
  }

  private void copy(PackagedFile file, Path to, long all) throws IOException {
    byte[] chunk = new byte[CHUNK];
    try (InputStream in = file.open();
        OutputStream out = Files.newOutputStream(to, StandardOpenOption.CREATE_NEW)) {
      for (int read = in.read(chunk); read >= 0; read = in.read(chunk)) {
        out.write(chunk, 0, read);
        written += read;
        progress.accept(Math.min(1, (double) written / all));
      }
    }
  }

  private void createFolders(Path wanted) throws IOException {
    if (!Files.isDirectory(wanted)) {
      if (Files.exists(wanted, LinkOption.NOFOLLOW_LINKS)) {
        throw new IOException(wanted + ": is a file, not a folder");
      }
      if (wanted.getParent() != null) {
        createFolders(wanted.getParent());
      }
      log.createFolder(wanted);
    }
  }

  /** Creates the folders of a file one by one; none of them may be a link that leads outside. */
  private void createParents(Path place, Path real) throws IOException {
    Path at = real;
    for (Path part : real.relativize(place.getParent())) {
      at = at.resolve(part);
      if (!Files.isDirectory(at) && !part.toString().isEmpty()) {
        log.createFolder(at);
      }
      if (!at.toRealPath().startsWith(real)) {
        throw outside(at);
      }
    }
  }

  private IOException outside(Path place) {
    return new IOException(place + ": lies outside of " + folder + ", and is not written");
  }
}
