package org.selectiverenderer.enricher.robot;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.selectiverenderer.document.file.DocumentFile;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.TaskExecutor;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/** Documents open in a session. */
public final class TestSessions {
  private TestSessions() {}

  /** Light or dark. */
  public static void theme(boolean dark) {
    GuiRobot.onEdt(() -> dark ? FlatDarkLaf.setup() : FlatLightLaf.setup());
  }

  /** A scene of these nodes, in a file of its own. */
  public static EnricherSession with(Path folder, String nodes) throws IOException {
    String text = "<X3D version='4.0'>\n<Scene>\n" + nodes + "</Scene>\n</X3D>\n";
    return open(Files.writeString(folder.resolve("scene.x3d"), text));
  }

  public static EnricherSession open(Path file) throws IOException {
    return open(file, new TaskExecutor(EventQueue::invokeLater));
  }

  public static EnricherSession open(Path file, TaskExecutor tasks) throws IOException {
    return new EnricherSession(DocumentFile.open(file), NodeCatalogue.load(), tasks, message -> {});
  }

  /** An object in two versions of which nothing is said. */
  public static String object(String name) {
    return """
    <Switch DEF='Switch_%s' whichChoice='0'>
      <Inline url='%s_v1.x3d'/>
      <Inline url='%s_v2.x3d'/>
    </Switch>
    """
        .formatted(name, name, name);
  }
}
