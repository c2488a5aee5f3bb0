package org.selectiverenderer.app.studies;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.files.InputFileReader;

/** The studies that were opened lately, the latest first, in a file of the user's settings. */
public final class RecentStudies {
  /** Most studies that are kept. */
  static final int MOST = 10;

  private final Path file;

  /**
   * @param settings folder of the user's settings; created with the first study
   */
  public RecentStudies(Path settings) {
    file = settings.resolve("studies");
  }

  /** Returns the study files; none where the list cannot be read, which is no harm. */
  public List<Path> list() {
    List<Path> studies = new ArrayList<>();
    if (!Files.isRegularFile(file)) {
      return studies;
    }
    try {
      for (String line : InputFileReader.text(file).lines().toList()) {
        if (!line.isBlank() && studies.size() < MOST) {
          studies.add(Path.of(line));
        }
      }
    } catch (IOException | InvalidPathException e) {
      return studies;
    }
    return studies;
  }

  /**
   * Puts a study first.
   *
   * @throws IOException if the list cannot be written
   */
  public void add(Path study) throws IOException {
    Path absolute = study.toAbsolutePath().normalize();
    List<Path> studies = list();
    studies.remove(absolute);
    studies.add(0, absolute);
    write(studies);
  }

  /**
   * Removes a study from the list; its files stay.
   *
   * @throws IOException if the list cannot be written
   */
  public void remove(Path study) throws IOException {
    List<Path> studies = list();
    if (studies.remove(study.toAbsolutePath().normalize())) {
      write(studies);
    }
  }

  private void write(List<Path> studies) throws IOException {
    Files.createDirectories(file.toAbsolutePath().getParent());
    StringBuilder text = new StringBuilder();
    studies.stream()
        .map(Path::toString)
        .filter(name -> name.lines().count() == 1)
        .limit(MOST)
        .forEach(name -> text.append(name).append('\n'));
    AtomicFileWriter.replace(file, text.toString().getBytes(StandardCharsets.UTF_8));
  }
}
