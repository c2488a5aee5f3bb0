package org.selectiverenderer;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * An import of a class of ours.
 *
 * @param file that imports
 * @param user the package of the file
 * @param used the package of the class, or the class itself for a member's import
 */
record SourceImport(Path file, String user, String used) {
  private static final Pattern PACKAGE = Pattern.compile("(?m)^package ([\\w.]+);");
  private static final Pattern IMPORT =
      Pattern.compile("(?m)^import (?:static )?(org\\.(?:selectiverenderer|web3d)[\\w.]*)\\.\\w+;");

  /** The imports of all main sources. */
  static List<SourceImport> all() throws IOException {
    List<SourceImport> found = new ArrayList<>();
    for (String root :
        List.of(
            "src/main/java", "tools/apartment/src/main/java", "tools/enricher-gui/src/main/java")) {
      try (Stream<Path> files = Files.walk(Path.of(root))) {
        for (Path file : files.filter(at -> at.toString().endsWith(".java")).toList()) {
          found.addAll(of(file));
        }
      }
    }
    return found;
  }

  private static List<SourceImport> of(Path file) throws IOException {
    String text = Files.readString(file);
    Matcher packaged = PACKAGE.matcher(text);
    String user = packaged.find() ? packaged.group(1) : "";
    return IMPORT
        .matcher(text)
        .results()
        .map(found -> new SourceImport(file, user, found.group(1)))
        .toList();
  }
}
