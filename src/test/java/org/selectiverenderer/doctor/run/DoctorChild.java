package org.selectiverenderer.doctor.run;

import org.lwjgl.system.MemoryUtil;
import org.selectiverenderer.doctor.Diagnosis;

/** A child process that does what drivers do. */
public final class DoctorChild {
  private DoctorChild() {}

  public static void main(String[] arguments) throws InterruptedException {
    switch (arguments[0]) {
      case "answers" -> {
        System.err.println("a library says this and that");
        send(Diagnosis.ok("child", "one"));
        System.out.println(ChildStarter.MARK + "{\"status\":");
        send(Diagnosis.warning("child", "two", "three"));
      }
      case "crashes" -> {
        send(Diagnosis.ok("child", "before the crash"));
        MemoryUtil.memPutByte(8, (byte) 1); // Nobody's memory.
      }
      case "hangs" -> Thread.sleep(600_000);
      case "mutters" -> System.out.println("libGL error: no driver\n");
      default -> throw new IllegalArgumentException(arguments[0]);
    }
  }

  private static void send(Diagnosis line) {
    System.out.println(ChildStarter.MARK + line.json());
  }
}
