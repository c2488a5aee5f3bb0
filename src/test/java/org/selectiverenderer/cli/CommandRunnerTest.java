package org.selectiverenderer.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.NoSuchFileException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.StandardOutputStream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

class CommandRunnerTest {
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  @Test
  void dataGoesToOutAndMessagesToErrAsUtf8() {
    ExitStatus status =
        run(
            console -> {
              console.out().println("Größe");
              console.message("läuft");
              return ExitStatus.DONE;
            });
    assertThat(status).isEqualTo(ExitStatus.DONE);
    assertThat(out.toString(StandardCharsets.UTF_8)).isEqualTo(line("Größe"));
    assertThat(err.toString(StandardCharsets.UTF_8)).isEqualTo(line("läuft"));
  }

  @Test
  void aSceneWithProblemsEndsWithStatusOne() {
    ExitStatus status =
        run(
            console -> {
              ProblemCollector problems = new ProblemCollector(console::problem);
              problems.warning(new SourceLocation("a.x3d", 3, 7), "odd");
              return ExitStatus.of(problems);
            });
    assertThat(status).isEqualTo(ExitStatus.PROBLEMS);
    assertThat(status.code()).isEqualTo(1);
    assertThat(messages()).isEqualTo(line("a.x3d:3:7: odd"));
  }

  @Test
  void anIoFailureIsOneLineAndStatusTwo() {
    assertFailure(new NoSuchFileException("a.x3d"), "no such file: a.x3d");
    assertFailure(new AccessDeniedException("a.x3d"), "permission denied: a.x3d");
    assertFailure(new IOException("port is gone"), "port is gone");
    assertFailure(new UncheckedIOException(new NoSuchFileException("b")), "no such file: b");
  }

  @Test
  void aMessageOfSeveralLinesIsJoined() {
    assertFailure(new IOException("one\n  two\r\n"), "one; two");
  }

  @Test
  void whatTheProgramDidWrongIsOneLineToo() {
    assertFailure(
        new IllegalStateException("oops"),
        "internal error, please report it: java.lang.IllegalStateException: oops");
  }

  @Test
  void debugShowsWhereAFailureCameFrom() {
    run(
        console -> {
          throw new IOException("gone");
        },
        "try",
        "--debug");
    assertThat(messages()).contains("gone").contains("at " + getClass().getName());
  }

  @Test
  void anUnusableEnvironmentIsSaidWithoutAHint() {
    assertFailure(
        CommandException.environment("no display; use --offscreen"), "no display; use --offscreen");
  }

  @Test
  void wrongUsageIsOneLineAndAHint() {
    ExitStatus status =
        run(
            console -> {
              throw CommandException.usage("--size needs --offscreen");
            });
    assertThat(status.code()).isEqualTo(2);
    assertThat(messages())
        .isEqualTo(
            line("selective-renderer try: --size needs --offscreen")
                + line("Try 'selective-renderer try --help'."));
  }

  @Test
  void anUnknownOptionAndABadValueAreWrongUsage() {
    assertThat(run(console -> ExitStatus.DONE, "try", "--cout=1")).isEqualTo(ExitStatus.FAILURE);
    assertThat(messages())
        .startsWith("selective-renderer try: Unknown option: '--cout=1'")
        .endsWith(line("Try 'selective-renderer try --help'."))
        .hasLineCount(2);
    err.reset();
    assertThat(run(console -> ExitStatus.DONE, "try", "--count=x")).isEqualTo(ExitStatus.FAILURE);
    assertThat(messages()).contains("--count").hasLineCount(2);
  }

  @Test
  void aMistypedCommandIsGuessed() {
    assertThat(run(console -> ExitStatus.DONE, "tri")).isEqualTo(ExitStatus.FAILURE);
    assertThat(messages())
        .isEqualTo(
            line("selective-renderer: unknown command 'tri'; did you mean try?")
                + line("Try 'selective-renderer --help'."));
  }

  @Test
  void aReaderThatHasGoneEndsTheCommandQuietly() {
    int[] written = new int[1];
    ExitStatus status =
        runInto(
            failing("Broken pipe"),
            console -> {
              for (int i = 0; i < 1000; i++, written[0]++) {
                console.out().println(i);
                console.out().flush();
              }
              return ExitStatus.DONE;
            });
    assertThat(status).isEqualTo(ExitStatus.DONE);
    assertThat(written[0]).isZero();
    assertThat(messages()).isEmpty();
  }

  @Test
  void helpIntoABrokenPipeIsQuietToo() {
    assertThat(runInto(failing("Broken pipe"), console -> ExitStatus.DONE, "try", "--help"))
        .isEqualTo(ExitStatus.DONE);
    assertThat(messages()).isEmpty();
  }

  @Test
  void aFullDiskBehindStandardOutputIsAFailure() {
    ExitStatus status =
        runInto(
            failing("No space left on device"),
            console -> {
              console.out().println("data");
              return ExitStatus.DONE;
            });
    assertThat(status).isEqualTo(ExitStatus.FAILURE);
    assertThat(messages()).contains("cannot write to standard output: No space left on device");
  }

  private void assertFailure(Exception failure, String sentence) {
    err.reset();
    ExitStatus status =
        run(
            console -> {
              if (failure instanceof IOException checked) {
                throw checked;
              }
              throw (RuntimeException) failure;
            });
    assertThat(status.code()).isEqualTo(2);
    assertThat(messages()).isEqualTo(line("selective-renderer try: " + sentence));
  }

  private ExitStatus run(Work work, String... args) {
    return runInto(out, work, args);
  }

  private ExitStatus runInto(OutputStream target, Work work, String... args) {
    Console console =
        new Console(
            new PrintStream(new StandardOutputStream(target), false, StandardCharsets.UTF_8),
            new PrintStream(err, true, StandardCharsets.UTF_8),
            false);
    String[] words = args.length == 0 ? new String[] {"try"} : args;
    return new CommandRunner(console).run(words, List.of(new TryCommand(console, work)));
  }

  private String messages() {
    return err.toString(StandardCharsets.UTF_8);
  }

  private static String line(String text) {
    return text + "\n";
  }

  private static OutputStream failing(String message) {
    return new OutputStream() {
      @Override
      public void write(int b) throws IOException {
        throw new IOException(message);
      }
    };
  }

  private interface Work {
    ExitStatus run(Console console) throws IOException;
  }

  @Command(name = "try", description = "Does what the test says.", footer = "  try --count 3")
  private static final class TryCommand extends CliCommand {
    private final Work work;

    @Option(names = "--count")
    private int count;

    TryCommand(Console console, Work work) {
      super(console);
      this.work = work;
    }

    @Override
    public ExitStatus run() throws IOException {
      return work.run(console());
    }
  }
}
