package org.selectiverenderer.validation.script;

import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.x3d.catalogue.FieldAccess;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.script.ProgramSyntax;
import org.selectiverenderer.x3d.script.ScriptProgram;

/** Reports syntax errors and missing event functions in the program of a Script. */
final class ProgramReport {
  private ProgramReport() {}

  static void of(ParsedNode script, ScriptProgram program, Findings findings) {
    ProgramSyntax syntax = ProgramSyntax.of(program);
    String name = script.name() == null ? "Script" : "Script " + script.name();
    for (ProgramSyntax.Fault fault : syntax.faults()) {
      findings.add(ScriptRules.SYNTAX, program.line(fault.line()), name, fault.message());
    }
    if (!syntax.faults().isEmpty() || program.text().isBlank()) {
      return;
    }
    NodeType type = script.type();
    for (FieldDefinition field : type.fields().subList(type.ownFrom(), type.fields().size())) {
      if (field.access() == FieldAccess.INPUT_ONLY
          && !syntax.names().contains(field.name())
          && !syntax.names().contains("set_" + field.name())) {
        findings.add(ScriptRules.NO_FUNCTION, script, field.name(), field.name());
      }
    }
  }
}
