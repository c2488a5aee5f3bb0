package org.selectiverenderer;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A library that {@code packaging/libraries} makes of some packages.
 *
 * @param artifact as Maven calls it
 * @param packages that it holds; two points at the end stand for those within
 * @param uses the artifacts that its POM names
 */
record Library(String artifact, List<String> packages, Set<String> uses) {
  private static final Path FOLDER = Path.of("packaging/libraries");
  private static final Pattern EXCLUSIONS =
      Pattern.compile("<exclusions>.*?</exclusions>", Pattern.DOTALL);
  private static final Pattern ARTIFACT = Pattern.compile("<artifactId>([^<]+)</artifactId>");

  static List<Library> all() throws IOException {
    List<Library> all = new ArrayList<>();
    try (DirectoryStream<Path> folders = Files.newDirectoryStream(FOLDER)) {
      for (Path folder : folders) {
        if (Files.exists(folder.resolve("packages.txt"))) {
          all.add(read(folder));
        }
      }
    }
    return all;
  }

  private static Library read(Path folder) throws IOException {
    String pom = Files.readString(folder.resolve("pom.xml"));
    List<String> artifacts = artifacts(EXCLUSIONS.matcher(pom).replaceAll(""));
    return new Library(
        artifacts.get(1), // after the parent
        Files.readAllLines(folder.resolve("packages.txt")),
        new LinkedHashSet<>(artifacts.subList(2, artifacts.size())));
  }

  private static List<String> artifacts(String pom) {
    List<String> artifacts = new ArrayList<>();
    Matcher matcher = ARTIFACT.matcher(pom);
    while (matcher.find()) {
      artifacts.add(matcher.group(1));
    }
    return artifacts;
  }

  boolean holds(String packageName) {
    return packages.stream()
        .anyMatch(
            held ->
                held.endsWith("..")
                    ? (packageName + ".").startsWith(held.substring(0, held.length() - 1))
                    : packageName.equals(held));
  }
}
