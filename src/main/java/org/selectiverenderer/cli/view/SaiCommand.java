package org.selectiverenderer.cli.view;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import org.selectiverenderer.app.sai.SaiRunner;
import org.selectiverenderer.cli.base.CliCommand;
import org.selectiverenderer.cli.base.LibraryProperties;
import org.selectiverenderer.cli.option.ConditionOptions;
import org.selectiverenderer.cli.output.Console;
import org.selectiverenderer.cli.output.ExitStatus;
import org.web3d.x3d.sai.X3DException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** For docs/xj3d.md; not in the help, since {@code run} does more with the browser inside. */
@Command(
    name = "sai",
    hidden = true,
    description = {
      "Runs the controller in the browser that the Scene Access Interface finds, "
          + "such as Xj3D, and prints what happens.",
      "Ends when the browser's window is closed; without a window, at the end of "
          + "standard input."
    },
    footer = "  ./selective-renderer sai scenes/trashcan.x3d")
public final class SaiCommand extends CliCommand {
  @Parameters(paramLabel = "SCENE", description = "X3D scene")
  private Path scene = Path.of("");

  @Mixin private ConditionOptions condition = new ConditionOptions();

  private final InputStream in;

  /**
   * @param in without a window, its end is the end of the run
   */
  public SaiCommand(Console console, InputStream in) {
    super(console);
    this.in = in;
  }

  @Override
  public ExitStatus run() throws IOException {
    if (!Files.isRegularFile(scene)) {
      throw new IOException(scene + ": the file does not exist");
    }
    LibraryProperties.swingFirst(); // The browser may be a Swing panel.
    CountDownLatch closed = new CountDownLatch(1);
    String url = scene.toAbsolutePath().normalize().toUri().toString();
    try (SaiRunner runner = SaiRunner.open(url, condition.settings(), this::print)) {
      if (runner.showWindow(closed::countDown)) {
        closed.await();
      } else {
        in.transferTo(java.io.OutputStream.nullOutputStream());
      }
      return ExitStatus.DONE;
    } catch (X3DException e) {
      throw new IOException(scene + ": " + e.getMessage(), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return ExitStatus.DONE;
    }
  }

  private void print(String line) {
    console().out().println(line);
    console().out().flush();
  }
}
