package org.selectiverenderer.validation.script;

import java.io.IOException;
import java.util.HashSet;
import java.util.Set;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.validation.FileOutline;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.validation.SceneCheck;
import org.selectiverenderer.validation.SceneView;
import org.selectiverenderer.x3d.files.Content;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.script.ProgramChoice;
import org.selectiverenderer.x3d.script.ScriptProgram;

/**
 * Checks Script programs in separate files, and reports those in other languages; {@code UrlCheck}
 * reports files that cannot be read.
 */
final class FileProgramCheck implements SceneCheck {
  @Override
  public void check(SceneView scene, Findings findings) {
    Set<Location> seen = new HashSet<>();
    for (FileOutline file : scene.files()) {
      for (ParsedNode node : file.nodes()) {
        if (node.type().is("X3DScriptNode") && seen.add(node.location())) {
          check(
              node, ProgramChoice.of(node, scene.root(), node.base(file.file().base())), findings);
        }
      }
    }
  }

  private static void check(ParsedNode node, ProgramChoice choice, Findings findings) {
    if (choice instanceof ProgramChoice.File program) {
      read(node, program.content(), findings);
    } else if (choice instanceof ProgramChoice.None none && none.language() != null) {
      findings.add(ScriptRules.LANGUAGE, node, none.language());
    }
  }

  private static void read(ParsedNode node, Content file, Findings findings) {
    try {
      ProgramReport.of(node, ScriptProgram.read(file), findings);
    } catch (IOException e) {
      // SR309 reports files that cannot be read.
    }
  }
}
