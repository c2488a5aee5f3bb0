package org.selectiverenderer.radiosity.output;

import java.nio.file.Path;
import java.util.Map;
import org.selectiverenderer.radiosity.bake.LitScene;
import org.selectiverenderer.runtime.instance.LightInstance;
import org.selectiverenderer.runtime.instance.ShapeInstance;

/** Stores light in vertex colours; all lights are switched off. */
public final class VertexForm implements LitForm {
  private final LitScene lit;
  private final FilePlaces places;

  public VertexForm(LitScene lit) {
    this.lit = lit;
    places = FilePlaces.of(lit.scene());
  }

  @Override
  public FilePlaces places() {
    return places;
  }

  @Override
  public String version(int place, String version) {
    return version;
  }

  @Override
  public void shape(LitFile into, int body, ShapeInstance shape) {
    new LitShapeWriter(lit).append(into.out(), body, into.nodes().define(shape.node()));
  }

  @Override
  public void light(LitFile into, LightInstance light, String container) {
    into.nodes().open(light.node(), container);
    into.nodes().values(light.node(), "on", into);
    into.out().attribute("on", "false").close();
  }

  @Override
  public Map<Path, byte[]> pictures() {
    return Map.of();
  }
}
