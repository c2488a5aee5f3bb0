package org.selectiverenderer.export;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.selectiverenderer.authoring.packaging.PackagedFile;

/**
 * The page that shows an exported scene in a web browser, with the X3D browser X_ITE: what the
 * build of the folder {@code web} has put on the class path.
 */
final class WebPage {
  private static final String FOLDER = "/org/selectiverenderer/web/";
  private static final String LIST = "files.txt";

  private final List<PackagedFile> files;

  private WebPage(List<PackagedFile> files) {
    this.files = List.copyOf(files);
  }

  /** Returns the page; empty if this program was built without Node.js, which makes it. */
  static Optional<WebPage> load() throws IOException {
    Optional<byte[]> list = read(LIST);
    if (list.isEmpty()) {
      return Optional.empty();
    }
    List<PackagedFile> files = new ArrayList<>();
    for (String name : new String(list.get(), StandardCharsets.UTF_8).lines().toList()) {
      byte[] content =
          read(name).orElseThrow(() -> new IOException("the program lacks its file " + name));
      files.add(new PackagedFile(Path.of(name), Path.of(name), Optional.of(content)));
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

  List<PackagedFile> files() {
    return files;
  }
}
