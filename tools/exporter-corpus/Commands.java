import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.selectiverenderer.cli.Main;

/**
 * Runs commands of the program in one process, as starting Java for each of a thousand takes long.
 *
 * <p>A line of standard input is a command, its arguments separated by tabs. The answer on standard
 * output is what the command prints, each line after "| ", and then a line with its exit status.
 */
public final class Commands {
  public static void main(String[] none) throws Exception {
    PrintStream answer = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    System.setErr(new PrintStream(java.io.OutputStream.nullOutputStream()));
    BufferedReader lines = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      ByteArrayOutputStream printed = new ByteArrayOutputStream();
      PrintStream both = new PrintStream(printed, true, StandardCharsets.UTF_8);
      int status;
      try {
        status = Main.execute(line.split("\t"), both, both);
      } catch (RuntimeException | Error e) {
        both.println("no answer but " + e);
        status = 3;
      }
      printed.toString(StandardCharsets.UTF_8).lines().forEach(text -> answer.println("| " + text));
      answer.println(status);
    }
    System.exit(0);
  }
}
