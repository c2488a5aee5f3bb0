package org.selectiverenderer.natives;

import com.formdev.flatlaf.FlatLightLaf;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.JFrame;
import org.selectiverenderer.base.natives.FlatLafLibrary;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.LibraryProperties;
import org.selectiverenderer.lsl.LslLibrary;
import org.selectiverenderer.models.Model;
import org.selectiverenderer.models.ModelPart;
import org.selectiverenderer.models.ModelReader;
import org.selectiverenderer.models.simplify.SimplificationTarget;
import org.selectiverenderer.models.simplify.Simplifier;
import org.selectiverenderer.openxr.HeadsetUnavailableException;
import org.selectiverenderer.openxr.XrHeadsetFinder;
import org.selectiverenderer.render.context.GlInfo;
import org.selectiverenderer.tracker.serial.SerialPorts;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/**
 * A process that uses one native library as the program does, and then prints what files the
 * process has in its memory.
 */
final class NativeLibraryUser {
  private NativeLibraryUser() {}

  public static void main(String[] args) throws IOException {
    LibraryProperties.set();
    switch (args[0]) {
      case "jSerialComm" -> SerialPorts.names();
      case "JOGL" -> GlInfo.binding();
      case "Assimp and meshoptimizer" -> simplify(Path.of(args[1]));
      case "OpenXR" -> headset();
      case "FlatLaf" -> look();
      case "libffi" -> liblsl(Path.of(args[1]));
      default -> throw new IllegalArgumentException(args[0]);
    }
    Files.readAllLines(Path.of("/proc/self/maps"), StandardCharsets.UTF_8).stream()
        .filter(line -> line.contains("/"))
        .map(line -> line.substring(line.indexOf('/')))
        .distinct()
        .forEach(System.out::println);
    System.exit(0); // JOGL's threads go on.
  }

  private static void simplify(Path file) throws IOException {
    Model model =
        new ModelReader(NodeCatalogue.load()).read(file, new ProblemCollector()).orElseThrow();
    new Simplifier()
        .simplify(
            model.parts().stream().map(ModelPart::mesh).toList(),
            new SimplificationTarget.Polygons(2));
  }

  private static void look() {
    LibraryProperties.allowSwing();
    FlatLafLibrary.use(NativeLibraryUser.class);
    FlatLightLaf.setup();
    new JFrame("look").pack(); // Asks for the system's frame.
  }

  private static void headset() {
    try {
      XrHeadsetFinder.begin().close();
    } catch (HeadsetUnavailableException e) {
      // The loader was asked, and has found no runtime.
    }
  }

  /** Any library will do: libffi is loaded before it is found out that it is another. */
  private static void liblsl(Path library) {
    for (Optional<Path> named : List.of(Optional.of(library), Optional.<Path>empty())) {
      try {
        LslLibrary.open(named);
      } catch (IOException e) {
        // None is installed.
      }
    }
  }
}
