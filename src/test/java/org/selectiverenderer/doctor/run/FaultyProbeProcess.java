package org.selectiverenderer.doctor.run;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.lwjgl.system.MemoryUtil;
import org.selectiverenderer.base.platform.ParentProcessWatcher;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.InterruptHandler;
import org.selectiverenderer.doctor.Diagnosis;
import org.selectiverenderer.doctor.Probe;

/** A child process that does what drivers do. */
public final class FaultyProbeProcess {
  /** The variable that names a file, which is made when the child hangs. */
  static final String READY = "DOCTOR_CHILD_READY";

  private FaultyProbeProcess() {}

  public static void main(String[] arguments) throws IOException, InterruptedException {
    switch (arguments[0]) {
      case "answers" -> {
        System.err.println("a library says this and that");
        send(Diagnosis.ok("child", "one"));
        System.out.println(ProbeProcess.MARK + "{\"status\":");
        send(Diagnosis.warning("child", "two", "three"));
      }
      case "crashes" -> {
        send(Diagnosis.ok("child", "before the crash"));
        MemoryUtil.memPutByte(8, (byte) 1); // Nobody's memory.
      }
      case "hangs" -> hang();
      case "examines" -> examine();
      case "mutters" -> System.out.println("libGL error: no driver\n");
      default -> throw new IllegalArgumentException(arguments[0]);
    }
  }

  private static void hang() throws IOException, InterruptedException {
    ParentProcessWatcher.whenItEnds(() -> Runtime.getRuntime().halt(2));
    String ready = System.getenv(READY);
    if (ready != null) {
      Files.createFile(Path.of(ready));
    }
    new CountDownLatch(1).await(10, TimeUnit.MINUTES);
  }

  /** Not a child: what begins them, as the command does. */
  private static void examine() throws IOException {
    Probe hangs =
        new Probe("hangs", "hangs", true, Probe.Place.APART, Duration.ofMinutes(10), found -> {});
    Doctor doctor = new Doctor(new ProbeProcess(DoctorTest::child), "/home/ada");
    try {
      InterruptHandler.interrupts(() -> doctor.examine(List.of(hangs)));
    } catch (CommandException e) {
      System.exit(2);
    }
  }

  private static void send(Diagnosis line) {
    System.out.println(ProbeProcess.MARK + line.json());
  }
}
