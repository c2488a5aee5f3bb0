package org.selectiverenderer.export;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Predicate;
import org.selectiverenderer.authoring.packaging.PackagedFile;

/**
 * A page for web browsers with the X3D browser X_ITE, which shows an exported scene or runs a
 * study: what the build of the folder {@code web} has put on the class path.
 */
public final class WebPage {
  private static final String FOLDER = "/org/selectiverenderer/web/";
  private static final String LIST = "files.txt";

  /** The files that only the page of a study needs; they begin alike. */
  private static final String STUDY = "study";

  private static final Path INDEX = Path.of("index.html");

  private final List<PackagedFile> files;

  private WebPage(List<PackagedFile> files) {
    this.files = List.copyOf(files);
  }

  /**
   * Returns the page that shows a scene; empty if this program was built without Node.js, which
   * makes it.
   */
  public static Optional<WebPage> ofScene() throws IOException {
    return load(name -> !studies(name));
  }

  /** Returns the page that runs a study, as {@link #ofScene}. */
  public static Optional<WebPage> ofStudy() throws IOException {
    return load(name -> studies(name) || name.startsWith("page/x_ite/"));
  }

  private static boolean studies(String name) {
    return String.valueOf(Path.of(name).getFileName()).startsWith(STUDY);
  }

  private static Optional<WebPage> load(Predicate<String> wanted) throws IOException {
    Optional<byte[]> list = read(LIST);
    if (list.isEmpty()) {
      return Optional.empty();
    }
    List<PackagedFile> files = new ArrayList<>();
    for (String name :
        new String(list.get(), StandardCharsets.UTF_8).lines().filter(wanted).toList()) {
      byte[] content =
          read(name).orElseThrow(() -> new IOException("the program lacks its file " + name));
      Path target = name.equals(STUDY + ".html") ? INDEX : Path.of(name);
      files.add(new PackagedFile(target, Path.of(name), Optional.of(content)));
    }
    return Optional.of(new WebPage(files));
  }

  private static Optional<byte[]> read(String name) throws IOException {
    try (InputStream in = WebPage.class.getResourceAsStream(FOLDER + name)) {
      return in == null ? Optional.empty() : Optional.of(Objects.requireNonNull(in).readAllBytes());
    }
  }

  /** Returns whether a file is a part of X_ITE that is loaded where a scene needs it. */
  static boolean part(PackagedFile file) {
    return file.target().startsWith(Path.of("page", "x_ite", "assets"))
        || file.target().toString().contains("LICENSE");
  }

  /** Returns the files of the page. */
  public List<PackagedFile> files() {
    return files;
  }
}
