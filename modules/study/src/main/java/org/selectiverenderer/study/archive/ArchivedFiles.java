package org.selectiverenderer.study.archive;

import com.fasterxml.jackson.core.JsonProcessingException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.files.Sha256;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.study.session.FileChecksumCalculator;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.StudyFiles;

/**
 * The files of a study for an archive: those in its folder, without the paths of a machine. Files
 * outside of the folder may not be the study's to give away; they are told by name and checksum.
 *
 * @param inside contents by their paths in the package
 * @param outside checksums of the other files by their names
 */
record ArchivedFiles(Map<String, byte[]> inside, Map<String, String> outside) {
  private static final Pattern DATA = Pattern.compile("(sub-[^/]*/.*)|participants\\.tsv");

  /** A JSON string that is an absolute path, other than that of a device. */
  private static final Pattern ABSOLUTE =
      Pattern.compile("\"((?:[A-Za-z]:|~)?(?:/|\\\\\\\\)(?!dev/)[^\"]*[/\\\\])([^\"/\\\\]*)\"");

  /**
   * A folder in which a path on Linux, macOS or Windows names a person, or an address of a file.
   */
  private static final Pattern PERSONAL =
      Pattern.compile(
          "file:/{1,3}[^\\s\"'<>]{1,200}|(?:/home/|/Users/|[A-Za-z]:[/\\\\]{1,2}Users[/\\\\]{1,2})[^/\\\\\\s\"'<>]{1,100}");

  private static final Pattern TEXT = Pattern.compile("(?i).*\\.(json|csv|tsv|x3d|wrl|txt|html?)");

  /**
   * Reads the files of a study.
   *
   * @param home the folder of the user, which no file should name
   * @throws IOException if a file cannot be read
   */
  static ArchivedFiles of(LoadedStudy material, String home, ProblemCollector problems)
      throws IOException {
    Path folder = material.study().folder().toAbsolutePath().normalize();
    Map<String, byte[]> inside = new TreeMap<>();
    Map<String, String> outside = new TreeMap<>();
    for (Path file : all(material)) {
      // On Windows a file may be on another drive, to which no relative path leads.
      boolean elsewhere = !Objects.equals(folder.getRoot(), file.toAbsolutePath().getRoot());
      String name = elsewhere ? "" : folder.relativize(file).toString().replace('\\', '/');
      byte[] content = InputFileReader.bytes(file);
      if (elsewhere || name.startsWith("../")) {
        outside.put(String.valueOf(file.getFileName()), Sha256.of(content));
      } else if (!DATA.matcher(name).matches()) {
        inside.put("study/" + name, told(file, content, home, problems));
      }
    }
    return new ArchivedFiles(inside, outside);
  }

  private static Set<Path> all(LoadedStudy material) throws IOException {
    Set<Path> all = new LinkedHashSet<>();
    for (Path file : StudyFiles.of(material)) {
      all.add(file);
      if (StudyFiles.isScene(file)) {
        for (String name :
            FileChecksumCalculator.ofScene(file, material.study().access()).keySet()) {
          Path named = file.resolveSibling(name).normalize();
          if (Files.isRegularFile(named)) {
            all.add(named);
          }
        }
      }
    }
    return all;
  }

  /** Returns a content without absolute paths in JSON, and warns of others. */
  private static byte[] told(Path file, byte[] content, String home, ProblemCollector problems) {
    if (!TEXT.matcher(file.toString()).matches()) {
      return content;
    }
    String text = new String(content, StandardCharsets.UTF_8);
    if (file.toString().toLowerCase(Locale.ROOT).endsWith(".json")) {
      Matcher paths = ABSOLUTE.matcher(text);
      String without = paths.replaceAll("\"$2\"");
      if (!without.equals(text) && valid(without)) {
        problems.warning(
            SourceLocation.of(file.toString()),
            "the file names absolute paths; in the package only the last parts of them are left");
        text = without;
        content = text.getBytes(StandardCharsets.UTF_8);
      }
    }
    Matcher named = PERSONAL.matcher(text);
    if (named.find()) {
      problems.warning(
          SourceLocation.of(file.toString()),
          "the file names '%s', a folder of a machine, and is in the package so; change it, and write the package again"
              .formatted(named.group()));
    } else if (home.length() > 3 && text.contains(home)) {
      problems.warning(
          SourceLocation.of(file.toString()),
          "the file names the folder %s of this machine, and is in the package so; change it, and"
                  .formatted(home)
              + " write the package again");
    }
    return content;
  }

  private static boolean valid(String json) {
    try {
      JsonTree.parseSettings(json);
      return true;
    } catch (JsonProcessingException e) {
      return false;
    }
  }
}
