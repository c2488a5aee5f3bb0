package org.selectiverenderer.command.output;

import java.util.concurrent.CountDownLatch;

/**
 * A command that does not stop when it is asked to, beside a library that keeps Java from ending.
 */
final class StuckCommand {
  static final String BEGUN = "begun";

  private StuckCommand() {}

  public static void main(String[] arguments) throws Exception {
    Runnable never = () -> InterruptHandler.await(new CountDownLatch(1), Double.MAX_VALUE);
    Runtime.getRuntime().addShutdownHook(new Thread(never));
    InterruptHandler.stops(
        () -> System.out.println("asked"),
        () -> {
          System.out.println(BEGUN);
          never.run();
        });
  }
}
