package org.selectiverenderer.cli.view;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.cli.option.TrackerFilterOptions;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.ProgramInvocation;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.InterruptHandler;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.tracker.TrackerException;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.emulator.EmulatedInterTrax2;
import org.selectiverenderer.tracker.emulator.HeadMotion;
import org.selectiverenderer.tracker.emulator.InterTrax2Emulator;
import org.selectiverenderer.tracker.report.CsvTrackOutput;
import org.selectiverenderer.tracker.report.JsonTrackOutput;
import org.selectiverenderer.tracker.report.TextTrackOutput;
import org.selectiverenderer.tracker.report.TrackOutput;
import org.selectiverenderer.tracker.report.TrackSession;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "track",
    description =
        "Shows what a head tracker sends, to set it up; or emulates a tracker, to "
            + "try the program without one.",
    footer = {
      "  ./selective-renderer track intertrax2:/dev/ttyUSB0 --output head.csv",
      "  ./selective-renderer track --emulate intertrax2 --link /tmp/tracker"
    })
public final class TrackCommand extends CliCommand {
  private enum Format {
    text,
    json
  }

  private enum Device {
    intertrax2
  }

  @Parameters(
      paramLabel = "SPEC",
      arity = "0..1",
      description =
          "tracker: intertrax2:/dev/ttyUSB0, fastrak:/dev/ttyUSB0@9600, "
              + "opentrack:4242, vrpn:Tracker0@host[:port], tcp:host:port, replay:FILE.csv "
              + "or none")
  private @Nullable String spec;

  @Option(
      names = "--duration",
      defaultValue = "Infinity",
      paramLabel = "S",
      description = "ends after S seconds (default: at Ctrl-C, or at the end of a replay)")
  private double duration;

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      defaultValue = "text",
      description =
          "format of the output: ${COMPLETION-CANDIDATES}; json has every record, "
              + "text a line four times per second (default: ${DEFAULT-VALUE})")
  private Format format = Format.text;

  @Option(
      names = "--output",
      paramLabel = "F.csv",
      description = "writes every record to a file that replay: can play")
  private @Nullable Path output;

  @Mixin private TrackerFilterOptions flags = new TrackerFilterOptions();

  @Option(
      names = "--emulate",
      paramLabel = "TRACKER",
      description = "emulates a tracker: ${COMPLETION-CANDIDATES}")
  private @Nullable Device emulated;

  @Option(
      names = "--link",
      paramLabel = "PATH",
      description = "path at which the emulated serial port appears, with --emulate")
  private @Nullable Path link;

  @Option(
      names = "--rate",
      defaultValue = "120",
      paramLabel = "HZ",
      description =
          "records per second of the emulated tracker, up to 480, with --emulate "
              + "(default: ${DEFAULT-VALUE})")
  private double rate;

  public TrackCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    if (!(duration > 0)) {
      throw CommandException.usage("--duration must be a number of seconds above 0");
    }
    if (emulated != null) {
      return emulate();
    }
    if (link != null) {
      throw CommandException.usage("--link needs --emulate");
    }
    return watch();
  }

  private ExitStatus watch() throws IOException {
    TrackerSpec tracker = tracker();
    OutputFile.check("--output", output, ".csv");
    CommandFileCheck files = new CommandFileCheck().writes("--output", output);
    if (tracker instanceof TrackerSpec.Replay replay) {
      files.reads("the replayed log", replay.file());
    }
    files.check();
    ProblemCollector problems = new ProblemCollector(console()::problem);
    List<TrackOutput> outputs = new ArrayList<>();
    outputs.add(
        switch (format) {
          case text -> new TextTrackOutput(console().out(), console().out()::flush);
          case json -> new JsonTrackOutput(console().out(), console().out()::flush);
        });
    try (CsvTrackOutput csv = output == null ? null : new CsvTrackOutput(output)) {
      if (csv != null) {
        outputs.add(csv);
      }
      TrackSession session = new TrackSession(tracker, flags.options(), problems::add, outputs);
      InterruptHandler.stops(session::stop, () -> session.run(duration));
    } catch (TrackerException e) {
      if (!problems.any()) {
        throw e;
      }
      console().message(e.getMessage()); // The log has errors, which have been listed.
    }
    return ExitStatus.of(problems);
  }

  private TrackerSpec tracker() {
    if (spec == null) {
      throw CommandException.usage(
          ProgramInvocation.in("no tracker given; name one, such as intertrax2:/dev/ttyUSB0"));
    }
    try {
      return TrackerSpec.parse(spec);
    } catch (IllegalArgumentException e) {
      throw CommandException.usage(e.getMessage());
    }
  }

  private ExitStatus emulate() throws IOException {
    if (link == null || spec != null) {
      throw CommandException.usage(
          "--emulate needs --link PATH, the path of the emulated serial port, and "
              + "takes no SPEC");
    }
    Path path = link;
    InterTrax2Emulator.Settings settings = settings();
    CountDownLatch stopping = new CountDownLatch(1);
    InterruptHandler.stops(
        stopping::countDown,
        () -> {
          try (EmulatedInterTrax2 device = EmulatedInterTrax2.start(path, settings)) {
            console()
                .message(
                    "the emulated InterTrax2 is ready; type in another terminal: "
                        + ProgramInvocation.name()
                        + " track intertrax2:"
                        + device.link());
            InterruptHandler.await(stopping, duration);
          }
        });
    return ExitStatus.DONE;
  }

  private InterTrax2Emulator.Settings settings() {
    try {
      return new InterTrax2Emulator.Settings(rate, HeadMotion.LOOKING_ABOUT);
    } catch (IllegalArgumentException e) {
      throw CommandException.usage("--rate: " + e.getMessage());
    }
  }
}
