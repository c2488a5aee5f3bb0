package org.selectiverenderer.doctor.probe;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.selectiverenderer.base.files.SettingsFolder;
import org.selectiverenderer.doctor.Diagnosis;

/** Checks the folders for settings, recovery copies and temporary files. */
final class FoldersProbe {
  private static final long ENOUGH_MB = 200;

  private FoldersProbe() {}

  static void run(Consumer<Diagnosis> found) throws IOException {
    Path settings = SettingsFolder.ofUser();
    found.accept(place("settings", settings));
    found.accept(place("temporary files", Path.of(System.getProperty("java.io.tmpdir", "."))));
  }

  /** Checks that a folder can be written; it need not exist yet. */
  static Diagnosis place(String subject, Path folder) throws IOException {
    Path there =
        Stream.iterate(folder.toAbsolutePath(), up -> up != null, Path::getParent)
            .filter(Files::exists)
            .findFirst()
            .orElseThrow(() -> new IOException(folder + ": has no root"));
    if (!Files.isDirectory(there)) {
      return Diagnosis.lacking(
          subject, folder + " cannot be made: " + there + " is a file", "move that file away");
    }
    try {
      if (there.equals(folder.toAbsolutePath())) {
        Files.delete(Files.createTempFile(there, ".selective-renderer", ".doctor"));
      } else if (!Files.isWritable(there)) {
        throw new IOException("permission denied");
      }
    } catch (IOException e) {
      return Diagnosis.lacking(
          subject,
          folder + " cannot be written to",
          "give yourself permission to write to " + there + ", or see whether the disk is full");
    }
    long free = Files.getFileStore(there).getUsableSpace() >> 20;
    String found = "%s, %,d MB free".formatted(folder, free);
    return free < ENOUGH_MB
        ? Diagnosis.warning(subject, found, "free disk space: sessions and recovery copies need it")
        : Diagnosis.ok(subject, found);
  }
}
