package org.selectiverenderer.radiosity.output;

import java.nio.file.Path;
import java.util.Map;
import org.selectiverenderer.browser.instance.LightInstance;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.radiosity.bake.VertexLitScene;

/** Stores light in vertex colours; all lights are switched off. */
public final class VertexColorFormat implements LitSceneFormat {
  private final VertexLitScene lit;
  private final OutputFileIndex places;

  public VertexColorFormat(VertexLitScene lit) {
    this.lit = lit;
    places = OutputFileIndex.of(lit.scene());
  }

  @Override
  public OutputFileIndex places() {
    return places;
  }

  @Override
  public String version(int place, String version) {
    return version;
  }

  @Override
  public void shape(LitFileWriter into, int body, ShapeInstance shape) {
    new VertexColorShapeWriter(lit).append(into.out(), body, into.nodes().define(shape.node()));
  }

  @Override
  public void light(LitFileWriter into, LightInstance light, String container) {
    into.nodes().open(light.node(), container);
    into.nodes().values(light.node(), "on", into);
    into.out().attribute("on", "false").close();
  }

  @Override
  public Map<Path, byte[]> pictures() {
    return Map.of();
  }
}
