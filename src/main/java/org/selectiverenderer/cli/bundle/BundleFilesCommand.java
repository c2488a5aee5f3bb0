package org.selectiverenderer.cli.bundle;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeMap;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import javax.imageio.ImageIO;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.ProgramVersion;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/**
 * Writes files for {@code packaging/package}; hidden in the help, since users of a package have
 * these files.
 */
@Command(
    name = BundleFilesCommand.NAME,
    hidden = true,
    description = "Writes the manual pages, completions for shells and icons of a package.",
    footer = "  ./selective-renderer bundle-files target/bundle-files")
public final class BundleFilesCommand extends CliCommand {
  /** The command's name. */
  public static final String NAME = "bundle-files";

  /** The icon sizes in pixels of the Icon Theme Specification for Linux desktops. */
  private static final List<Integer> PNG_SIZES = List.of(16, 24, 32, 48, 64, 128, 256, 512);

  private static final List<Integer> ICO_SIZES = List.of(16, 24, 32, 48, 64, 256);

  @Parameters(paramLabel = "DIR", description = "output folder; created if it does not exist")
  private Path folder = Path.of("");

  private final Supplier<CommandLine> commands;
  private final IntFunction<BufferedImage> icon;

  /**
   * @param commands all commands of the program
   * @param icon draws the program's icon with a given side length in pixels
   */
  public BundleFilesCommand(
      Console console, Supplier<CommandLine> commands, IntFunction<BufferedImage> icon) {
    super(console);
    this.commands = commands;
    this.icon = icon;
  }

  @Override
  public ExitStatus run() throws IOException {
    CommandLine root = commands.get();
    for (var page : ManPageWriter.of(root.getCommandSpec(), ProgramVersion.number()).entrySet()) {
      write("man/" + page.getKey() + ".1", page.getValue().getBytes(StandardCharsets.UTF_8));
    }
    String bash = AutoComplete.bash(ProgramVersion.PROGRAM, root);
    write("bash/" + ProgramVersion.PROGRAM, bash.getBytes(StandardCharsets.UTF_8));
    write("zsh/_" + ProgramVersion.PROGRAM, zsh(bash).getBytes(StandardCharsets.UTF_8));
    icons();
    return ExitStatus.DONE;
  }

  /**
   * Returns a completion file for zsh, which recognises it by its first line and has run bash's
   * completions since version 4.2.
   */
  private static String zsh(String bash) {
    return "#compdef "
        + ProgramVersion.PROGRAM
        + "\nautoload -U +X bashcompinit && bashcompinit\n"
        + bash
        + "\n_bash_complete -o default -F _complete_"
        + ProgramVersion.PROGRAM
        + "\n";
  }

  private void icons() throws IOException {
    TreeMap<Integer, byte[]> pictures = new TreeMap<>();
    for (int size : PNG_SIZES) {
      pictures.put(size, png(size));
      write("icons/" + size + ".png", pictures.get(size));
    }
    TreeMap<Integer, byte[]> small = new TreeMap<>(pictures);
    small.keySet().retainAll(ICO_SIZES);
    write("icons/" + ProgramVersion.PROGRAM + ".ico", IconFileWriter.ico(small));
    write("icons/" + ProgramVersion.PROGRAM + ".icns", IconFileWriter.icns(pictures));
  }

  private byte[] png(int size) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ImageIO.write(icon.apply(size), "png", out);
    return out.toByteArray();
  }

  private void write(String name, byte[] content) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    Files.write(file, content);
  }
}
