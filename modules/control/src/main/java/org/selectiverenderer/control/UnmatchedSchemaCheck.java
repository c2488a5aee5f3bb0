package org.selectiverenderer.control;

import java.util.Collection;
import java.util.List;
import org.selectiverenderer.control.ControlProblem.Severity;
import org.selectiverenderer.schema.SchemaUsage;
import org.selectiverenderer.schema.SchemaUsage.Unmatched;
import org.selectiverenderer.schema.SwitchSchemas;
import org.web3d.x3d.sai.X3DNode;

/**
 * Finds schemas without effect: those that only areas or only objects name. They may be intended,
 * so they are reported as remarks, or as warnings if the other side has a nearly equal name.
 */
final class UnmatchedSchemaCheck {
  private record Namer(String name, X3DNode node) {}

  private UnmatchedSchemaCheck() {}

  /** Returns one problem for each such schema, at the first node that names it. */
  static List<ControlProblem> of(
      Collection<ControlledArea> areas, Collection<VersionedObject> objects) {
    SchemaUsage<Namer> use = new SchemaUsage<>();
    for (ControlledArea area : areas) {
      Namer namer = new Namer(area.name(), area.sensor());
      area.schemas().ifPresent(schemas -> use.area(namer, schemas));
    }
    for (VersionedObject object : objects) {
      Namer namer = new Namer(object.name(), object.node());
      List<List<String>> schemas = object.schemas().map(SwitchSchemas::byChoice).orElse(List.of());
      use.object(namer, schemas, object.atStart());
      for (ControlledField field : object.fields()) {
        use.object(namer, field.schemas().orElseThrow().byChoice(), field.shown());
      }
    }
    return use.unmatched().stream().map(UnmatchedSchemaCheck::problem).toList();
  }

  private static ControlProblem problem(Unmatched<Namer> unmatched) {
    Namer namer = unmatched.node();
    return unmatched.meant().isPresent()
        ? ControlProblem.warning(namer.name(), namer.node(), unmatched.message())
        : new ControlProblem(namer.name(), namer.node(), Severity.INFO, unmatched.message());
  }
}
