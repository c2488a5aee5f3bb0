package org.selectiverenderer.cli.hostile;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import org.selectiverenderer.cli.Main;

/**
 * A process that runs one command after the other, because a process for each would take most of
 * the time of a test. In: lines of arguments, tab-separated. Out, for each: a line of the exit
 * status, standard output and standard error, the latter two in Base64.
 */
final class CommandLoop {
  private CommandLoop() {}

  /** Runs commands until its standard input ends. */
  public static void main(String[] none) throws IOException {
    PrintStream answers = System.out;
    System.setOut(new PrintStream(new ByteArrayOutputStream(), true, StandardCharsets.UTF_8));
    BufferedReader commands =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    for (String line = commands.readLine(); line != null; line = commands.readLine()) {
      ByteArrayOutputStream out = new ByteArrayOutputStream();
      ByteArrayOutputStream err = new ByteArrayOutputStream();
      int status =
          Main.execute(
              line.split("\t"),
              new PrintStream(out, true, StandardCharsets.UTF_8),
              new PrintStream(err, true, StandardCharsets.UTF_8));
      answers.println(status + " " + base64(out) + " " + base64(err));
      answers.flush();
    }
    System.exit(0);
  }

  private static String base64(ByteArrayOutputStream text) {
    return "=" + Base64.getEncoder().encodeToString(text.toByteArray());
  }
}
