package org.selectiverenderer.study.session;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.base.files.PrivateFiles;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.headlog.BidsMotionFiles;
import org.selectiverenderer.study.headlog.HeadLog;
import org.selectiverenderer.study.headlog.HeadLogReader;

/**
 * Converts the head logs of a session to BIDS motion data, each once, on the thread {@code
 * motion-data}, so that a long log does not delay the next exposure. Files that a crash loses are
 * converted again from the head logs when the session is resumed.
 */
final class BidsMotionConverter implements AutoCloseable {
  private final SessionFolder folder;
  private final SessionJournal journal;
  private final ExecutorService writer =
      Executors.newSingleThreadExecutor(
          work -> {
            Thread thread = new Thread(work, "motion-data");
            thread.setDaemon(true);
            return thread;
          });
  private volatile @Nullable IOException failure;

  BidsMotionConverter(SessionFolder folder, SessionJournal journal) {
    this.folder = folder;
    this.journal = journal;
  }

  /**
   * Queues the conversion of a head log, also of one that a crash truncated; does nothing if its
   * files exist.
   */
  void write(String headName) {
    writer.execute(
        () -> {
          try {
            writeNow(headName);
          } catch (IOException e) {
            failure = e;
          }
        });
  }

  private void writeNow(String headName) throws IOException {
    Path log = folder.path().resolve("head").resolve(headName + ".csv");
    Path motion = folder.path().resolve("motion");
    PrivateFiles.requireNoLink(motion);
    String stem = folder.motionStem(headName);
    if (!Files.isRegularFile(log) || Files.exists(motion.resolve(stem + BidsMotionFiles.DATA))) {
      return;
    }
    ProblemCollector problems = new ProblemCollector();
    Optional<HeadLog> read = HeadLogReader.read(log, problems);
    if (read.isPresent()) {
      FileTransaction writing = new FileTransaction(FileOperations.PRIVATE_UNLINKED);
      BidsMotionFiles.files(
              read.get(), stem, SessionFolder.task(headName), BidsMotionFiles.SOFTWARE)
          .forEach(
              (name, text) ->
                  writing.addLasting(motion.resolve(name), text.getBytes(StandardCharsets.UTF_8)));
      BidsMotionFiles.eyes(read.get(), stem, SessionFolder.task(headName), BidsMotionFiles.SOFTWARE)
          .forEach((name, bytes) -> writing.addLasting(motion.resolve(name), bytes));
      writing.commit();
    }
    List<String> said = problems.list().stream().map(Problem::message).toList();
    if (!said.isEmpty()) {
      journal.tell("head-log", Map.of("file", headName, "problems", said));
    }
  }

  /**
   * Waits until all files are written.
   *
   * @throws IOException if a file could not be written
   */
  @Override
  public void close() throws IOException {
    writer.shutdown();
    try {
      while (!writer.awaitTermination(1, TimeUnit.MINUTES)) {
        // The loop waits for a slow disk.
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    IOException failed = failure;
    if (failed != null) {
      throw new IOException(
          folder.path().resolve("motion")
              + ": BIDS motion data could not be written ("
              + failed.getMessage()
              + "); the head logs are kept",
          failed);
    }
  }
}
