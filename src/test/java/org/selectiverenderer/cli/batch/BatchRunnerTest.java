package org.selectiverenderer.cli.batch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;

class BatchRunnerTest {
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();
  private final Console console = new Console(stream(out), stream(err), false);

  private static PrintStream stream(ByteArrayOutputStream bytes) {
    return new PrintStream(bytes, true, StandardCharsets.UTF_8);
  }

  private static List<Path> files(int count) {
    return IntStream.range(0, count).mapToObj(i -> Path.of("f" + i)).toList();
  }

  private String out() {
    return out.toString(StandardCharsets.UTF_8);
  }

  private String err() {
    return err.toString(StandardCharsets.UTF_8);
  }

  private static ExitStatus name(Path file, Console own) {
    own.out().print(file + "\n");
    return ExitStatus.DONE;
  }

  @Test
  void resultsComeInTheOrderOfTheFilesThoughTheFirstIsDoneLast() throws IOException {
    int count = 2 * Runtime.getRuntime().availableProcessors();
    CountDownLatch others = new CountDownLatch(Runtime.getRuntime().availableProcessors() - 1);

    ExitStatus status =
        new BatchRunner(console, BatchOutputFormat.LINES)
            .run(
                files(count),
                (file, own) -> {
                  if (file.equals(Path.of("f0"))) {
                    assertThat(others.await(1, TimeUnit.MINUTES)).isTrue();
                  } else {
                    others.countDown();
                  }
                  return name(file, own);
                });

    assertThat(status).isEqualTo(ExitStatus.DONE);
    assertThat(out())
        .isEqualTo(files(count).stream().map(file -> file + "\n").collect(Collectors.joining()));
  }

  @Test
  void aFileThatCannotBeReadIsReportedAndTheOthersGoOn() throws IOException {
    ExitStatus status =
        new BatchRunner(console, BatchOutputFormat.JSON_ARRAY)
            .run(
                files(4),
                (file, own) -> {
                  switch (file.toString()) {
                    case "f0" -> throw new IOException("f0:3:5: is no X3D");
                    case "f2" -> throw CommandException.usage("there is no group Office");
                    default -> own.out().println(file.toString().substring(1));
                  }
                  return ExitStatus.DONE;
                });

    assertThat(status).isEqualTo(ExitStatus.PROBLEMS);
    assertThat(err()).isEqualTo("f0:3:5: is no X3D\nf2: there is no group Office\n");
    assertThat(out()).isEqualTo("[\n1,\n3\n]\n");
  }

  @Test
  void anInternalErrorNamesItsFileAndFailsTheCommandInTheEnd() throws IOException {
    ExitStatus status =
        new BatchRunner(console, BatchOutputFormat.LINES)
            .run(
                files(3),
                (file, own) -> {
                  if (file.equals(Path.of("f1"))) {
                    throw new IllegalStateException("oops");
                  }
                  return name(file, own);
                });

    assertThat(status).isEqualTo(ExitStatus.FAILURE);
    assertThat(err()).startsWith("f1: internal error, please report it").contains("oops");
    assertThat(out()).isEqualTo("f0\nf2\n");
  }

  @Test
  void anArrayOfNothingIsStillJsonAndATableKeepsItsHeaderOnce() throws IOException {
    new BatchRunner(console, BatchOutputFormat.JSON_ARRAY)
        .run(files(2), (file, own) -> ExitStatus.PROBLEMS);
    assertThat(out()).isEqualTo("[\n]\n");

    out.reset();
    new BatchRunner(console, BatchOutputFormat.table("name\n"))
        .run(files(2), BatchRunnerTest::name);
    assertThat(out()).isEqualTo("name\nf0\nf1\n");
  }

  @Test
  void doesNotBeginFarAheadOfAFileThatTakesLong() throws IOException {
    int most = 4 * Runtime.getRuntime().availableProcessors();
    AtomicInteger begun = new AtomicInteger();
    AtomicInteger printed = new AtomicInteger();
    AtomicInteger furthest = new AtomicInteger();
    PrintStream counting =
        new PrintStream(out, true, StandardCharsets.UTF_8) {
          @Override
          public void write(byte[] bytes, int offset, int length) {
            if (length > 0 && bytes[offset] == 'f') {
              printed.incrementAndGet();
            }
            super.write(bytes, offset, length);
          }
        };

    new BatchRunner(new Console(counting, stream(err), false), BatchOutputFormat.LINES)
        .run(
            files(20 * most),
            (file, own) -> {
              int ahead = begun.incrementAndGet() - printed.get();
              furthest.accumulateAndGet(ahead, Math::max);
              return name(file, own);
            });

    assertThat(furthest.get()).isBetween(1, most + 1);
  }

  @Test
  void whatOutputSaysEndsTheBatch() {
    PrintStream full =
        new PrintStream(out, true, StandardCharsets.UTF_8) {
          @Override
          public void write(byte[] bytes, int offset, int length) {
            throw new IllegalStateException("nobody reads");
          }
        };

    assertThatThrownBy(
            () ->
                new BatchRunner(new Console(full, full, false), BatchOutputFormat.LINES)
                    .run(files(100), BatchRunnerTest::name))
        .hasMessage("nobody reads");
  }
}
