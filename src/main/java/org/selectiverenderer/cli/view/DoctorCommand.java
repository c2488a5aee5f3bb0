package org.selectiverenderer.cli.view;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.platform.ParentProcessWatcher;
import org.selectiverenderer.cli.option.FormatOption;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.ProgramVersion;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.InterruptHandler;
import org.selectiverenderer.doctor.Diagnosis;
import org.selectiverenderer.doctor.Probe;
import org.selectiverenderer.doctor.probe.ProbeCatalogue;
import org.selectiverenderer.doctor.report.DoctorReport;
import org.selectiverenderer.doctor.run.Doctor;
import org.selectiverenderer.doctor.run.ProbeProcess;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "doctor",
    description = {
      "Reports what this machine has and lacks: Java, display, OpenGL and its speed, headset,"
          + " serial ports, sound.",
      "Include its output in a bug report."
    },
    footer = {
      "  ./selective-renderer doctor",
      "  ./selective-renderer doctor --format json > machine.json"
    })
public final class DoctorCommand extends CliCommand {
  private static final String ONE = "--probe";

  @Mixin private FormatOption format = new FormatOption();

  @Option(
      names = "--ask-ports",
      description =
          "sends the commands of an InterTrax2 to every serial port to find one; other devices at"
              + " these ports receive them too")
  private boolean askPorts;

  @Option(
      names = ONE,
      hidden = true,
      description = "makes one probe, for the process that began it")
  private @Nullable String one;

  private final String program;

  /**
   * @param program the name of the main class that child processes of probes run
   */
  public DoctorCommand(Console console, String program) {
    super(console);
    this.program = program;
  }

  @Override
  public ExitStatus run() throws IOException {
    if (one != null) {
      ParentProcessWatcher.whenItEnds(() -> Runtime.getRuntime().halt(ExitStatus.FAILURE.code()));
    }
    return InterruptHandler.interrupts(() -> one == null ? examine() : answer(one));
  }

  private ExitStatus examine() throws IOException, InterruptedException {
    List<String> arguments =
        askPorts ? List.of("doctor", "--ask-ports", ONE) : List.of("doctor", ONE);
    Doctor doctor =
        new Doctor(ProbeProcess.of(program, arguments), System.getProperty("user.home", ""));
    String version = ProgramVersion.number();
    List<Diagnosis> lines = new ArrayList<>();
    lines.add(Diagnosis.ok("program", ProgramVersion.PROGRAM + " " + version));
    lines.addAll(doctor.examine(ProbeCatalogue.all(askPorts)));
    DoctorReport report = new DoctorReport(version, lines);
    console().out().print(format.json() ? report.json() : report.text());
    console().message("doctor: " + report.summary());
    return report.healthy() ? ExitStatus.DONE : ExitStatus.PROBLEMS;
  }

  private ExitStatus answer(String name) throws InterruptedException {
    Probe probe =
        ProbeCatalogue.all(askPorts).stream()
            .filter(each -> each.name().equals(name))
            .findFirst()
            .orElseThrow(() -> CommandException.usage(ONE + ": there is no probe " + name));
    Doctor.look(probe, this::send);
    return ExitStatus.DONE;
  }

  /** Prints and flushes a line, because the next part of a probe may end the process. */
  private void send(Diagnosis line) {
    console().out().println(ProbeProcess.MARK + line.json());
    console().out().flush();
  }
}
