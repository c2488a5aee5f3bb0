package org.selectiverenderer.validation.script;

import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.script.ScriptProgram;
import org.selectiverenderer.x3d.script.ScriptSyntax;

/** Reports syntax errors and missing event functions in the program of a Script. */
final class ScriptProgramInspector {
  private ScriptProgramInspector() {}

  static void of(ParsedNode script, ScriptProgram program, FindingCollector findings) {
    ScriptSyntax syntax = ScriptSyntax.of(program);
    String name = script.name() == null ? "Script" : "Script " + script.name();
    for (ScriptSyntax.Fault fault : syntax.faults()) {
      findings.add(ScriptRules.SYNTAX, program.line(fault.line()), name, fault.message());
    }
    if (!syntax.faults().isEmpty() || program.text().isBlank()) {
      return;
    }
    NodeType type = script.type();
    for (FieldDefinition field : type.fields().subList(type.ownFrom(), type.fields().size())) {
      if (field.access() == AccessType.INPUT_ONLY
          && !syntax.names().contains(field.name())
          && !syntax.names().contains("set_" + field.name())) {
        findings.add(ScriptRules.NO_FUNCTION, script, field.name(), field.name());
      }
    }
  }
}
