package org.selectiverenderer;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A module of the reactor, as its POM describes it.
 *
 * @param name the last name of its folder; {@code desktop} for the folder {@code src}
 * @param folder from the top of the checkout
 * @param uses the names of the modules that its main classes may use
 */
record MavenModule(String name, Path folder, Set<String> uses) {
  private static final Pattern MODULE = Pattern.compile("<module>([^<]+)</module>");
  private static final Pattern PARENT = Pattern.compile("<parent>.*?</parent>", Pattern.DOTALL);
  private static final Pattern ARTIFACT = Pattern.compile("<artifactId>([^<]+)</artifactId>");
  private static final Pattern DEPENDENCY =
      Pattern.compile("<dependency>(.*?)</dependency>", Pattern.DOTALL);

  /** Returns all modules of the root POM. */
  static List<MavenModule> all() throws IOException {
    Map<String, Path> folders = new TreeMap<>();
    Matcher module = MODULE.matcher(Files.readString(Path.of("pom.xml")));
    while (module.find()) {
      Path folder = Path.of(module.group(1));
      if (folder.startsWith("packaging")) {
        continue; // It gathers what others build.
      }
      folders.put(artifact(pom(folder)), folder);
    }
    List<MavenModule> modules = new ArrayList<>();
    for (Path folder : folders.values()) {
      Set<String> uses = new TreeSet<>();
      Matcher dependency = DEPENDENCY.matcher(pom(folder));
      while (dependency.find()) {
        Path used = folders.get(artifact(dependency.group(1)));
        if (used != null && !dependency.group(1).contains("<scope>test</scope>")) {
          uses.add(name(used));
        }
      }
      modules.add(new MavenModule(name(folder), folder, uses));
    }
    return modules;
  }

  /** Returns the Java files of its main classes. */
  List<Path> mainSources() throws IOException {
    Path sources = mainFolder();
    if (!Files.isDirectory(sources)) {
      return List.of();
    }
    try (Stream<Path> files = Files.walk(sources)) {
      return files.filter(file -> file.toString().endsWith(".java")).sorted().toList();
    }
  }

  /** Returns the names of its packages. */
  Set<String> packages() throws IOException {
    Set<String> packages = new TreeSet<>();
    for (Path source : mainSources()) {
      packages.add(
          mainFolder().relativize(source.getParent()).toString().replaceAll("[/\\\\]", "."));
    }
    return packages;
  }

  private Path mainFolder() {
    return folder.resolve(name.equals("desktop") ? "main/java" : "src/main/java");
  }

  private static String name(Path folder) {
    return folder.equals(Path.of("src")) ? "desktop" : folder.getFileName().toString();
  }

  private static String pom(Path folder) throws IOException {
    return PARENT.matcher(Files.readString(folder.resolve("pom.xml"))).replaceAll("");
  }

  private static String artifact(String pom) {
    Matcher artifact = ARTIFACT.matcher(pom);
    return artifact.find() ? artifact.group(1) : "";
  }
}
