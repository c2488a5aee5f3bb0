package org.selectiverenderer.runtime.sai;

import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Route;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.web3d.x3d.sai.InvalidReadableFieldException;
import org.web3d.x3d.sai.InvalidWritableFieldException;

/** Checks and makes the routes that an application adds (X3D 4.0, 4.4.8.2). */
final class Routes {
  private Routes() {}

  /**
   * Returns a route between two fields, given by the names of the fields or of their events.
   *
   * @throws InvalidReadableFieldException if the first field sends no events
   * @throws InvalidWritableFieldException if the second receives none, or of another type
   */
  static Route between(Node from, String readableField, Node to, String writableField) {
    FieldDefinition out =
        from.type()
            .output(readableField)
            .orElseThrow(
                () ->
                    new InvalidReadableFieldException(
                        from + " has no output field " + readableField));
    FieldDefinition in =
        to.type()
            .input(writableField)
            .orElseThrow(
                () ->
                    new InvalidWritableFieldException(to + " has no input field " + writableField));
    if (out.type() != in.type()) {
      throw new InvalidWritableFieldException(
          "%s of %s cannot be routed to %s of %s: the types %s and %s differ"
              .formatted(out.name(), from, in.name(), to, out.type(), in.type()));
    }
    return new Route(from, out.index(), to, in.index());
  }
}
