package org.selectiverenderer.enricher.settings;

import java.io.File;
import java.io.IOException;
import java.io.Reader;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.regex.Pattern;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.HostPattern;
import org.selectiverenderer.x3d.url.HttpFetcher;

/** The window's settings, as keys with strings and numbers in one file of the user's. */
public final class EnricherSettings {
  private final Path file;
  private final Properties values = new Properties();

  /**
   * @param folder folder of the user's settings; created when the settings are stored
   */
  public EnricherSettings(Path folder) {
    this.file = folder.resolve("enricher.properties");
  }

  /**
   * Reads the stored settings, if there are any.
   *
   * @throws IOException with one line if the file cannot be read; the defaults apply then
   */
  public void load() throws IOException {
    if (!Files.isRegularFile(file)) {
      return;
    }
    try (Reader in = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
      values.load(in);
    } catch (IOException | IllegalArgumentException e) {
      values.clear();
      throw new IOException(file + ": the settings cannot be read; the defaults are used", e);
    }
  }

  /** Writes the settings. */
  public void store() throws IOException {
    Files.createDirectories(file.toAbsolutePath().getParent());
    StringWriter text = new StringWriter();
    values.store(text, "Enricher");
    AtomicFileWriter.replace(file, text.toString().getBytes(StandardCharsets.UTF_8));
  }

  /**
   * The folders and hosts that scenes may read from besides their own files: the keys {@code
   * allow}, folders separated as in the system's search paths, and {@code allow-net}, hosts
   * separated by commas.
   *
   * @throws IllegalArgumentException with a sentence, if a host is invalid
   */
  public ContentAccessPolicy access() {
    List<Path> folders = new ArrayList<>();
    for (String folder : word("allow", "").split(Pattern.quote(File.pathSeparator))) {
      if (!folder.isBlank()) {
        folders.add(Path.of(folder.strip()));
      }
    }
    List<HostPattern> hosts = new ArrayList<>();
    for (String host : word("allow-net", "").split(",")) {
      if (!host.isBlank()) {
        hosts.add(new HostPattern(host));
      }
    }
    return new ContentAccessPolicy(folders, new HttpFetcher(hosts));
  }

  public String word(String key, String usual) {
    return values.getProperty(key, usual);
  }

  public int number(String key, int usual) {
    String word = values.getProperty(key, "");
    return word.matches("-?\\d{1,9}") ? Integer.parseInt(word) : usual;
  }

  public boolean flag(String key, boolean usual) {
    return Boolean.parseBoolean(word(key, Boolean.toString(usual)));
  }

  public void put(String key, Object value) {
    values.setProperty(key, value.toString());
  }
}
