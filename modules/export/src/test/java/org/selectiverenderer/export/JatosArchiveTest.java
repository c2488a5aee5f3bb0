package org.selectiverenderer.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.packaging.PackageWriter;
import org.selectiverenderer.authoring.packaging.PackagedFile;

class JatosArchiveTest {
  private static final Path PAGE = Path.of("study.html");

  @TempDir Path folder;

  private static PackagedFile file(String name, String content) {
    byte[] bytes = content.getBytes(StandardCharsets.UTF_8);
    return new PackagedFile(Path.of(name), Path.of(name), Optional.of(bytes));
  }

  private List<PackagedFile> study(String text) throws IOException {
    Path wood = Files.write(folder.resolve("wood.png"), new byte[] {1, 2, 3});
    return List.of(
        file("study.html", "<p>" + text + "</p>"),
        file("page/study.js", "start();"),
        new PackagedFile(Path.of("scene", "wood.png"), wood, Optional.empty()));
  }

  private static String description(List<PackagedFile> archive) {
    return new String(archive.get(0).changed().orElseThrow(), StandardCharsets.UTF_8);
  }

  @Test
  void archiveHoldsTheDescriptionAndOneFolder() throws IOException {
    Path zip = folder.resolve("kitchen.jzip");
    PackageWriter.intoZip(
        JatosArchive.files("Η κουζίνα: Kitchen \"1\"", PAGE, study("Hello")), zip, done -> {});
    try (ZipFile read = new ZipFile(zip.toFile())) {
      assertThat(read.stream().map(ZipEntry::getName))
          .containsExactly(
              "study.jas",
              "kitchen-1-f2699649/study.html",
              "kitchen-1-f2699649/page/study.js",
              "kitchen-1-f2699649/scene/wood.png");
      assertThat(read.getInputStream(read.getEntry("kitchen-1-f2699649/scene/wood.png")))
          .hasBinaryContent(new byte[] {1, 2, 3});
      assertThat(read.getInputStream(read.getEntry("study.jas")))
          .asString(StandardCharsets.UTF_8)
          .isEqualTo(
              """
              {
                "version" : "3",
                "data" : {
                  "uuid" : "2f2304ab-430d-3f4a-934c-63dd4c742202",
                  "title" : "Η κουζίνα: Kitchen \\"1\\"",
                  "description" : "",
                  "groupStudy" : false,
                  "dirName" : "kitchen-1-f2699649",
                  "comments" : "",
                  "jsonData" : null,
                  "componentList" : [ {
                    "uuid" : "88ccdea8-6220-3992-9529-41bb578f7173",
                    "title" : "Η κουζίνα: Kitchen \\"1\\"",
                    "htmlFilePath" : "study.html",
                    "reloadable" : true,
                    "active" : true,
                    "comments" : "",
                    "jsonData" : null
                  } ],
                  "batchList" : [ ]
                }
              }
              """);
    }
  }

  @Test
  void sameStudyIsTheSameInJatosAndChangedOneIsAnother() throws IOException {
    String description = description(JatosArchive.files("Kitchen", PAGE, study("Hello")));
    assertThat(description(JatosArchive.files("Kitchen", PAGE, study("Hello"))))
        .isEqualTo(description);
    assertThat(uuids(description(JatosArchive.files("Kitchen", PAGE, study("Good day")))))
        .doesNotContainAnyElementsOf(uuids(description));
    assertThat(uuids(description(JatosArchive.files("Lounge", PAGE, study("Hello")))))
        .doesNotContainAnyElementsOf(uuids(description));
  }

  private static List<String> uuids(String description) {
    return description.lines().filter(line -> line.contains("\"uuid\"")).toList();
  }

  @Test
  void folderHasNameThatJatosAllows() throws IOException {
    assertThat(description(JatosArchive.files("Κουζίνα / ../..", PAGE, study(""))))
        .containsPattern("\"dirName\" : \"study-[0-9a-f]{8}\"");
    assertThat(description(JatosArchive.files("Long ".repeat(40), PAGE, study(""))))
        .containsPattern("\"dirName\" : \"[a-z-]{50,60}-[0-9a-f]{8}\"");
  }

  @Test
  void pageMustBeThere() {
    assertThatThrownBy(() -> JatosArchive.files("Kitchen", Path.of("index.html"), study("")))
        .hasMessage("index.html is not one of the files");
  }
}
