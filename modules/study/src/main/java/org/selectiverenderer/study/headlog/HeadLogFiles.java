package org.selectiverenderer.study.headlog;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.stream.Stream;
import org.selectiverenderer.base.files.DiskSync;
import org.selectiverenderer.base.files.PrivateFiles;
import org.selectiverenderer.formats.csv.CsvWriter;

/**
 * The two files of a head log, its CSV and the description beside it. They are opened before
 * anything else of a session begins, so that an obstacle is reported at once; existing files are
 * changed only when the log begins. Files created for a log that never began are deleted.
 */
public final class HeadLogFiles implements HeadLogWriter.Lines, AutoCloseable {
  private final Claimed csv;
  private final Claimed json;
  private boolean begun;

  private HeadLogFiles(Claimed csv, Claimed json) {
    this.csv = csv;
    this.json = json;
  }

  private record Claimed(Path file, FileChannel channel, boolean made) {
    static Claimed of(Path file, boolean replace) throws IOException {
      boolean there = Files.exists(file);
      if (there && !replace) {
        throw new FileAlreadyExistsException(file.toString());
      }
      try {
        return new Claimed(
            file,
            PrivateFiles.open(
                file,
                StandardOpenOption.WRITE,
                there ? StandardOpenOption.CREATE : StandardOpenOption.CREATE_NEW),
            !there);
      } catch (FileAlreadyExistsException e) {
        throw e; // Another program has just created it.
      } catch (FileSystemException e) {
        throw new IOException(file + ": the head log cannot be written there", e);
      }
    }

    void write(String text) throws IOException {
      DiskSync.write(channel, text.getBytes(StandardCharsets.UTF_8));
    }

    void close(boolean keep) throws IOException {
      channel.close();
      if (!keep && made) {
        Files.deleteIfExists(file);
      }
    }
  }

  /**
   * Returns the paths of a log's files, including those of the tracker's records.
   *
   * @param csv file name ending in .csv; the description beside it ends in .json
   */
  public static List<Path> of(Path csv) {
    return Stream.concat(
            Stream.of(csv, HeadLogMetadata.beside(csv)), TrackerLogWriter.beside(csv).stream())
        .toList();
  }

  /**
   * Opens the files of a log for writing.
   *
   * @param replace whether existing files may be replaced
   * @throws FileAlreadyExistsException if a file exists and may not be replaced
   * @throws IOException if a file cannot be written
   */
  public static HeadLogFiles claim(Path csv, boolean replace) throws IOException {
    Path description = HeadLogMetadata.beside(csv);
    if (!replace && Files.exists(description)) {
      throw new FileAlreadyExistsException(description.toString());
    }
    Claimed log = Claimed.of(csv, replace);
    try {
      return new HeadLogFiles(log, Claimed.of(description, replace));
    } catch (IOException e) {
      log.close(false);
      throw e;
    }
  }

  /** Returns the log's CSV file. */
  Path csv() {
    return csv.file();
  }

  /**
   * Begins the log: writes the description, and the header of the CSV.
   *
   * @return takes the lines of the log
   */
  HeadLogWriter.Lines begin(HeadLogMetadata description) throws IOException {
    csv.channel().truncate(0);
    json.channel().truncate(0);
    begun = true;
    csv.write(CsvWriter.bare().row(headers(description)).toString());
    json.write(description.json());
    json.channel().force(true);
    csv.channel().force(true);
    DiskSync.forceFolder(csv.file().toAbsolutePath().getParent());
    return this;
  }

  private static List<String> headers(HeadLogMetadata description) {
    return HeadLogColumn.of(description.eyes()).stream().map(HeadLogColumn::header).toList();
  }

  @Override
  public void write(String text) throws IOException {
    csv.write(text);
  }

  @Override
  public void keep() throws IOException {
    csv.channel().force(false);
  }

  /** Closes both files; a second call does nothing. */
  @Override
  public void close() throws IOException {
    if (!csv.channel().isOpen()) {
      return;
    }
    try {
      json.close(begun);
    } finally {
      csv.close(begun);
    }
  }
}
