package org.selectiverenderer.app.start;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.base.files.HomeFolder;

/** Finds the folder of the user's documents, whose name depends on the language of a desktop. */
public final class DocumentsFolder {
  /** Reads the setting of xdg-user-dirs, which most desktops of Linux use. */
  private static final Pattern NAMED =
      Pattern.compile("(?m)^XDG_DOCUMENTS_DIR=\"(\\$HOME)?(/?[^\"$`\\\\]*)\"");

  private static final long MOST_BYTES = 1 << 16;

  private DocumentsFolder() {}

  /** Returns the folder of the user who runs this process; it need not exist. */
  public static Path ofUser() {
    return of(HomeFolder.ofUser(), System.getenv());
  }

  static Path of(Path home, Map<String, String> environment) {
    Path usual = home.resolve("Documents");
    try {
      Path named = Path.of(environment.getOrDefault("XDG_CONFIG_HOME", ""));
      Path file = (named.isAbsolute() ? named : home.resolve(".config")).resolve("user-dirs.dirs");
      if (!Files.isRegularFile(file) || Files.size(file) > MOST_BYTES) {
        return usual;
      }
      Matcher line = NAMED.matcher(Files.readString(file, StandardCharsets.UTF_8));
      if (!line.find()) {
        return usual;
      }
      Path documents =
          line.group(1) == null
              ? Path.of(line.group(2))
              : home.resolve(line.group(2).replaceFirst("^/+", ""));
      return documents.isAbsolute() ? documents : usual;
    } catch (IOException | InvalidPathException e) {
      return usual;
    }
  }
}
