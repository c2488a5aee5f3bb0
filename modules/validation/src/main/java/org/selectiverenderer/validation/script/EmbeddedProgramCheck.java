package org.selectiverenderer.validation.script;

import java.util.HashSet;
import java.util.Set;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.SceneNodeIterator;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.script.ScriptProgram;

/**
 * Checks Script programs embedded in the scene; that of a prototype is checked once, however many
 * instances there are.
 */
final class EmbeddedProgramCheck implements FileCheck {
  @Override
  public void check(FileContext file, FindingCollector findings) {
    Set<SourceLocation> seen = new HashSet<>();
    for (ParsedNode node : SceneNodeIterator.all(file.scene())) {
      if (node.type().is("X3DScriptNode") && seen.add(node.location())) {
        ScriptProgram.in(node)
            .ifPresent(program -> ScriptProgramInspector.of(node, program, findings));
      }
    }
  }
}
