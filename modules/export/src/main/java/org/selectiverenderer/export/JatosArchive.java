package org.selectiverenderer.export;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.UUID;
import org.selectiverenderer.authoring.packaging.PackagedFile;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.files.Sha256;
import org.selectiverenderer.formats.json.JsonWriter;

/**
 * A study archive of JATOS, which a laboratory imports there: a zip file, by convention with the
 * ending {@code .jzip}, of a description and one folder with the files of the study. {@code
 * docs/web-data.md} describes the format.
 */
public final class JatosArchive {
  private static final String DESCRIPTION = "study.jas";

  /** The version of the description that JATOS reads since its version 3. */
  private static final String VERSION = "3";

  private static final int LONGEST_NAME = 60;

  private JatosArchive() {}

  /**
   * Returns the files of an archive. The same study gives the same archive, which JATOS imports
   * over the one that it has; a changed study is another one there, with results of its own.
   *
   * @param title what researchers read in JATOS
   * @param page the page that participants open, one of the files
   * @param files the files that a web server would have
   * @throws IOException if a file cannot be read, with a sentence
   */
  public static List<PackagedFile> files(String title, Path page, List<PackagedFile> files)
      throws IOException {
    if (files.stream().noneMatch(file -> file.target().equals(page))) {
      throw new IllegalArgumentException(page + " is not one of the files");
    }
    String checksum = checksum(title, page, files);
    String folder = folder(title, checksum);
    List<PackagedFile> archive = new ArrayList<>();
    archive.add(description(title, page, folder, checksum));
    for (PackagedFile file : files) {
      archive.add(
          new PackagedFile(Path.of(folder).resolve(file.target()), file.source(), file.changed()));
    }
    return archive;
  }

  private static PackagedFile description(String title, Path page, String folder, String checksum) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("version", VERSION);
    ObjectNode study = json.putObject("data");
    study.put("uuid", uuid("study", checksum));
    study.put("title", title);
    study.put("description", "");
    study.put("groupStudy", false);
    study.put("dirName", folder);
    study.put("comments", "");
    study.putNull("jsonData");
    ObjectNode component = study.putArray("componentList").addObject();
    component.put("uuid", uuid("component", checksum));
    component.put("title", title);
    component.put("htmlFilePath", url(page));
    // A participant who reloads the page goes on: it sends what it kept.
    component.put("reloadable", true);
    component.put("active", true);
    component.put("comments", "");
    component.putNull("jsonData");
    study.putArray("batchList"); // JATOS adds its default batch
    Path name = Path.of(DESCRIPTION);
    byte[] text = JsonWriter.of(json).getBytes(StandardCharsets.UTF_8);
    return new PackagedFile(name, name, Optional.of(text));
  }

  /** Returns a folder's name that JATOS allows and that no other study has by chance. */
  private static String folder(String title, String checksum) {
    String name = title.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-");
    name = name.substring(0, Math.min(LONGEST_NAME, name.length())).replaceAll("^-|-$", "");
    return (name.isEmpty() ? "study" : name) + "-" + checksum.substring(0, 8);
  }

  private static String uuid(String what, String checksum) {
    byte[] name = (what + " " + checksum).getBytes(StandardCharsets.UTF_8);
    return UUID.nameUUIDFromBytes(name).toString();
  }

  /** Returns a checksum of a study, for which names and contents count. */
  private static String checksum(String title, Path page, List<PackagedFile> files)
      throws IOException {
    StringBuilder list = new StringBuilder(title + '\n' + url(page) + '\n');
    for (PackagedFile file : files) {
      byte[] content =
          file.changed().isPresent() ? file.changed().get() : InputFileReader.bytes(file.source());
      list.append(Sha256.of(content)).append(' ').append(url(file.target())).append('\n');
    }
    return Sha256.of(list.toString().getBytes(StandardCharsets.UTF_8));
  }

  private static String url(Path target) {
    return target.toString().replace('\\', '/');
  }
}
