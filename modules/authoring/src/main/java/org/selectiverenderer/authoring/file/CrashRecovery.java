package org.selectiverenderer.authoring.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Properties;
import java.util.UUID;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.files.Sha256;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Saves copies of unsaved documents in a folder of the user, so that a crash loses only a few
 * seconds of work. A session never overwrites the copies of another one; copies of programs that
 * are still running are not found.
 */
public final class CrashRecovery {
  private static final String CONTENT = ".scene";
  private static final String ABOUT = ".properties";
  private static final String STEP = "Recover unsaved changes";

  private final Path folder;
  private final String session = UUID.randomUUID().toString().substring(0, 8);

  /**
   * A recovery copy of a document.
   *
   * @param file file of the document
   * @param when time of the copy
   * @param content file of the copy
   */
  public record RecoveryCopy(Path file, Instant when, Path content) {}

  /**
   * @param folder created with the first copy
   */
  public CrashRecovery(Path folder) {
    this.folder = folder;
  }

  /** Saves a copy of a document, which replaces this session's previous one. */
  public void keep(Path file, DocumentSnapshot snapshot) throws IOException {
    Files.createDirectories(folder);
    String key = key(file);
    AtomicFileWriter.replace(folder.resolve(key + CONTENT), snapshot.bytes());
    String about =
        "file="
            + escaped(file.toAbsolutePath().toString())
            + "\nprocess="
            + ProcessHandle.current().pid()
            + "\n";
    AtomicFileWriter.replace(
        folder.resolve(key + ABOUT), about.getBytes(StandardCharsets.ISO_8859_1));
  }

  /** Escapes a value for java.util.Properties, which would also write the time. */
  private static String escaped(String value) {
    StringBuilder escaped = new StringBuilder();
    for (char c : value.toCharArray()) {
      if (c == '\\') {
        escaped.append("\\\\");
      } else if (c < ' ' || c > '~') {
        escaped.append(String.format(Locale.ROOT, "\\u%04x", (int) c));
      } else {
        escaped.append(c);
      }
    }
    return escaped.toString();
  }

  /** Deletes this session's copy of a document that was saved or discarded. */
  public void forget(Path file) throws IOException {
    forget(key(file));
  }

  /** Deletes the copy of an earlier session. */
  public void forget(RecoveryCopy kept) throws IOException {
    String name = String.valueOf(kept.content().getFileName());
    forget(name.substring(0, name.length() - CONTENT.length()));
  }

  private void forget(String key) throws IOException {
    Files.deleteIfExists(folder.resolve(key + ABOUT));
    Files.deleteIfExists(folder.resolve(key + CONTENT));
  }

  private String key(Path file) {
    byte[] name = file.toAbsolutePath().normalize().toString().getBytes(StandardCharsets.UTF_8);
    return Sha256.of(name).substring(0, 16) + "-" + session;
  }

  /**
   * Returns the copies of sessions that have ended, the latest first. Unreadable copies are
   * skipped.
   */
  public List<RecoveryCopy> found() throws IOException {
    List<RecoveryCopy> found = new ArrayList<>();
    if (!Files.isDirectory(folder)) {
      return found;
    }
    try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*" + ABOUT)) {
      for (Path about : files) {
        kept(about).ifPresent(found::add);
      }
    }
    found.sort((a, b) -> b.when().compareTo(a.when()));
    return found;
  }

  private Optional<RecoveryCopy> kept(Path about) throws IOException {
    Properties properties = new Properties();
    try (InputStream in = Files.newInputStream(about)) {
      properties.load(in);
    } catch (IllegalArgumentException e) {
      return Optional.empty(); // not written by us
    }
    String file = properties.getProperty("file", "");
    String name = String.valueOf(about.getFileName());
    String key = name.substring(0, name.length() - ABOUT.length());
    Path content = folder.resolve(key + CONTENT);
    if (key.endsWith("-" + session)
        || file.isEmpty()
        || !Files.isRegularFile(content)
        || running(properties)) {
      return Optional.empty();
    }
    return Optional.of(
        new RecoveryCopy(Path.of(file), Files.getLastModifiedTime(content).toInstant(), content));
  }

  private static boolean running(Properties properties) {
    String process = properties.getProperty("process", "");
    if (!process.matches("\\d{1,18}")) {
      return false;
    }
    long pid = Long.parseLong(process);
    return pid != ProcessHandle.current().pid()
        && ProcessHandle.of(pid)
            .filter(ProcessHandle::isAlive)
            .flatMap(handle -> handle.info().command())
            .equals(ProcessHandle.current().info().command());
  }

  /**
   * Opens a recovery copy: the file with the unsaved changes as one undo step, or the changed scene
   * alone if the file was deleted. The copy is taken over by this session.
   */
  public DocumentFile open(RecoveryCopy kept) throws IOException {
    DocumentFile opened = restored(kept);
    keep(opened.path(), opened.document().snapshot());
    forget(kept);
    return opened;
  }

  private static DocumentFile restored(RecoveryCopy kept) throws IOException {
    byte[] bytes = Files.readAllBytes(kept.content());
    SceneDocument recovered = SceneDocument.of(kept.file().toString(), bytes);
    if (!Files.isRegularFile(kept.file())) {
      return DocumentFile.unsaved(kept.file(), recovered);
    }
    DocumentFile opened = DocumentFile.open(kept.file());
    SceneDocument document = opened.document();
    String before = document.snapshot().text();
    String after = recovered.snapshot().text();
    if (opened.document().locked().isPresent()) {
      return DocumentFile.unsaved(kept.file(), recovered);
    }
    if (!before.equals(after)) {
      document.perform(new Edit(STEP, List.of(between(before, after))));
    }
    return opened;
  }

  private static TextEdit between(String before, String after) {
    int most = Math.min(before.length(), after.length());
    int start = 0;
    while (start < most && before.charAt(start) == after.charAt(start)) {
      start++;
    }
    int same = 0;
    while (same < most - start
        && before.charAt(before.length() - 1 - same) == after.charAt(after.length() - 1 - same)) {
      same++;
    }
    return new TextEdit(
        start, before.length() - same, after.substring(start, after.length() - same));
  }
}
