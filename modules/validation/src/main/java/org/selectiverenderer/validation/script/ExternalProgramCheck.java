package org.selectiverenderer.validation.script;

import java.io.IOException;
import java.util.HashSet;
import java.util.Set;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.validation.FileOutline;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.SceneCheck;
import org.selectiverenderer.validation.SceneContext;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.script.ScriptProgram;
import org.selectiverenderer.x3d.script.ScriptProgramSelection;
import org.selectiverenderer.x3d.url.UrlContent;

/**
 * Checks Script programs in separate files, and reports those in other languages; {@code UrlCheck}
 * reports files that cannot be read.
 */
final class ExternalProgramCheck implements SceneCheck {
  @Override
  public void check(SceneContext scene, FindingCollector findings) {
    Set<SourceLocation> seen = new HashSet<>();
    for (FileOutline file : scene.files()) {
      for (ParsedNode node : file.nodes()) {
        if (node.type().is("X3DScriptNode") && seen.add(node.location())) {
          check(
              node,
              ScriptProgramSelection.of(node, scene.root(), node.base(file.file().base())),
              findings);
        }
      }
    }
  }

  private static void check(
      ParsedNode node, ScriptProgramSelection choice, FindingCollector findings) {
    if (choice instanceof ScriptProgramSelection.File program) {
      read(node, program.content(), findings);
    } else if (choice instanceof ScriptProgramSelection.None none && none.language() != null) {
      findings.add(ScriptRules.LANGUAGE, node, none.language());
    }
  }

  private static void read(ParsedNode node, UrlContent file, FindingCollector findings) {
    try {
      ScriptProgramInspector.of(node, ScriptProgram.read(file), findings);
    } catch (IOException e) {
      // SR309 reports files that cannot be read.
    }
  }
}
