package org.selectiverenderer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Test;

/** META-INF/THIRD-PARTY.txt beside the libraries that the program is built with. */
class ThirdPartyTest {
  private static final Path PAGE = Path.of("src/main/resources/META-INF/THIRD-PARTY.txt");
  private static final Pattern ROW =
      Pattern.compile("(?m)^([\\w.-]+:[\\w.-]+) +(\\S+) +(\\S+) +(.+)$");

  /** A jar's place in a repository of Maven: group, artifact, version. */
  private static final Pattern JAR = Pattern.compile("(.+)/([^/]+)/([^/]+)/\\2-\\3[^/]*\\.jar");

  /** Beginnings of groups that only tests use, or what formats and runs them. */
  private static final Pattern OF_TESTS =
      Pattern.compile(
          "(org\\.(junit|opentest4j|apiguardian|assertj|slf4j|yaml|openjdk\\.jmh|checkerframework)"
              + "|com\\.(tngtech|networknt|ethlo|google|fasterxml\\.jackson\\.dataformat)"
              + "|net\\.(bytebuddy|sf\\.jopt-simple))\\b.*");

  @Test
  void namesEveryLibraryOfTheJarWithItsVersion() throws IOException {
    Map<String, String> rows =
        rows().stream().collect(Collectors.toMap(row -> row.get(0), row -> row.get(1)));
    Map<String, String> libraries = libraries();
    assertThat(libraries).as("used as script-engine has it").doesNotContainKey("org.mozilla:rhino");
    libraries.put("org.mozilla:rhino", rhino());
    assertThat(new TreeMap<>(rows)).isEqualTo(new TreeMap<>(libraries));
  }

  @Test
  void namesLicencesByTheirSpdxIdentifiers() throws IOException {
    assertThat(rows())
        .extracting(row -> row.get(2))
        .isSubsetOf(
            "Apache-2.0",
            "BSD-2-Clause",
            "BSD-3-Clause",
            "ISC",
            "LGPL-2.0-or-later",
            "MIT",
            "MPL-2.0");
  }

  @Test
  void theTextsThatItPointsToAreThere() throws IOException {
    String page = page();
    List<String> files = new ArrayList<>();
    Matcher name = Pattern.compile("(?<![\\w.])(META-INF|org)/[\\w./-]*\\w").matcher(page);
    while (name.find()) {
      files.add(name.group());
    }
    assertThat(files)
        .hasSizeGreaterThan(20)
        .allMatch(
            file ->
                file.equals("META-INF/LICENSE") // The build puts LICENSE there.
                    || getClass().getClassLoader().getResource(file) != null);
    // Texts that are "below" have a heading with a word of the library's name or group.
    List<String> headings =
        Pattern.compile("(?m)^(\\S.*)\\n-{3,}$")
            .matcher(page)
            .results()
            .map(heading -> heading.group(1))
            .toList();
    for (List<String> row : rows()) {
      if (row.get(3).startsWith("below")) {
        assertThat(headings)
            .as(row.get(0))
            .anyMatch(
                heading ->
                    Stream.of(heading.toLowerCase(Locale.ROOT).split("\\W+"))
                        .anyMatch(word -> word.length() > 3 && row.get(0).contains(word)));
      }
    }
  }

  /** docs/native-libraries.md has a row for each library with machine code, and no other. */
  @Test
  void everyNativeLibraryIsListedWithItsVersion() throws IOException {
    Map<String, String> found = new TreeMap<>();
    for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
      Matcher jar = JAR.matcher(entry.replace(File.separatorChar, '/'));
      if (jar.matches() && hasNativeFiles(Path.of(entry))) {
        found.put(jar.group(2), jar.group(3));
      }
    }
    Map<String, String> listed =
        Pattern.compile("(?m)^\\| `([\\w-]+)`.*?\\| ([\\d.]+) \\|")
            .matcher(Files.readString(Path.of("docs/native-libraries.md")))
            .results()
            .collect(Collectors.toMap(row -> row.group(1), row -> row.group(2)));
    assertThat(new TreeMap<>(listed)).isEqualTo(found);
  }

  private static boolean hasNativeFiles(Path jar) throws IOException {
    try (ZipFile zip = new ZipFile(jar.toFile())) {
      return zip.stream().anyMatch(file -> file.getName().matches(".+\\.(so|dll|dylib|jnilib)"));
    }
  }

  private static String page() throws IOException {
    return Files.readString(PAGE, StandardCharsets.UTF_8);
  }

  /** Library, version, licence, text. */
  private static List<List<String>> rows() throws IOException {
    return ROW.matcher(page())
        .results()
        .map(row -> List.of(row.group(1), row.group(2), row.group(3), row.group(4)))
        .toList();
  }

  /** Returns the version of Rhino that the module script-engine contains. */
  private static String rhino() throws IOException {
    Matcher version =
        Pattern.compile("<rhino.version>(.+)</rhino.version>")
            .matcher(Files.readString(Path.of("pom.xml")));
    assertThat(version.find()).isTrue();
    return version.group(1);
  }

  /** Returns the libraries on the program's class path: group:artifact to version. */
  private static Map<String, String> libraries() {
    List<String> entries =
        Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
            .map(entry -> entry.replace(File.separatorChar, '/'))
            .toList();
    int repository =
        entries.stream().mapToInt(entry -> entry.indexOf("org/assertj/")).max().orElseThrow();
    Map<String, String> libraries = new TreeMap<>();
    for (String entry : entries) {
      Matcher jar = JAR.matcher(entry.substring(Math.min(repository, entry.length())));
      if (jar.matches()) {
        String group = jar.group(1).replace('/', '.');
        if (!OF_TESTS.matcher(group).matches()) {
          libraries.putIfAbsent(group + ":" + jar.group(2), jar.group(3));
        }
      }
    }
    return libraries;
  }
}
