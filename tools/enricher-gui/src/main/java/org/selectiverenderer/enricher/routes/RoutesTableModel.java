package org.selectiverenderer.enricher.routes;

import java.util.List;
import org.selectiverenderer.authoring.routes.SceneRoute;
import org.selectiverenderer.enricher.table.RowTableModel;
import org.selectiverenderer.enricher.text.Texts;

/** The table of ROUTEs. */
@SuppressWarnings("serial") // never written
final class RoutesTableModel extends RowTableModel<SceneRoute> {
  private static final long serialVersionUID = 1L;

  static final int FROM = 0;
  static final int TO = 1;
  static final int TYPE = 2;
  static final int FAULT = 3;

  RoutesTableModel() {
    super(
        Texts.of("routes.column.from"),
        Texts.of("routes.column.to"),
        Texts.of("routes.column.type"),
        Texts.of("routes.column.fault"));
  }

  void routes(List<SceneRoute> routes) {
    update(routes);
  }

  @Override
  protected Object cell(SceneRoute route, int column) {
    return switch (column) {
      case FROM -> route.fromNode() + "." + route.fromField();
      case TO -> route.toNode() + "." + route.toField();
      case TYPE -> route.type().map(String::valueOf).orElse("");
      default -> fault(route);
    };
  }

  private static String fault(SceneRoute route) {
    return switch (route.fault()) {
      case NONE -> "";
      case INCOMPLETE -> Texts.of("routes.incomplete");
      case NO_SOURCE -> Texts.of("routes.nonode", route.fromNode());
      case NO_TARGET -> Texts.of("routes.nonode", route.toNode());
      case NOT_SENT -> Texts.of("routes.notsent", route.fromNode(), route.fromField());
      case NOT_RECEIVED -> Texts.of("routes.notreceived", route.toNode(), route.toField());
      case TYPES -> Texts.of("routes.types");
      case REPEATED -> Texts.of("routes.repeated");
    };
  }
}
