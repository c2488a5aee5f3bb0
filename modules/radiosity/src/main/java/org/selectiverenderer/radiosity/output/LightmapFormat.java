package org.selectiverenderer.radiosity.output;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.selectiverenderer.browser.instance.LightInstance;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.formats.image.PngEncoder;
import org.selectiverenderer.radiosity.atlas.AtlasBuilder;
import org.selectiverenderer.radiosity.bake.DiffuseTexture;
import org.selectiverenderer.radiosity.bake.LightmapImage;
import org.selectiverenderer.radiosity.bake.LightmapImageSet;
import org.selectiverenderer.radiosity.bake.LightmappedScene;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.x3d.url.UrlRelativizer;
import org.selectiverenderer.x3d.write.FieldValueFormatter;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Stores light in lightmap images beside the X3D files. A matte shape has an Appearance with a
 * lightmap and no material, so that the lightmap is shown as it is (X3D 3.3, 17.2.2.4; X3D 4.0,
 * 17.2.2.5). A glossy shape has a Material that reflects highlights only and emits its lightmap
 * (X3D 4.0, 17.2.2.4); then lights stay on. A shape whose own texture stays has both in a
 * MultiTexture (18.4.3).
 */
public final class LightmapFormat implements LitSceneFormat {
  /** The X3D version that has {@code emissiveTexture} and UnlitMaterial. */
  private static final String NEW = "4.0";

  private final LightmappedScene lit;
  private final LightmapImageSet painted;
  private final SpecularMaterials gloss;
  private final HighlightLightWriter lamps;
  private final OutputFileIndex places;
  private final BrightenedImageFiles images = new BrightenedImageFiles();
  private final Map<Integer, Path> files = new LinkedHashMap<>();
  private final Map<Path, Integer> numbers = new HashMap<>();
  private final Map<Path, Map<String, String>> appearances = new HashMap<>();

  /**
   * @param lamps writes the lights, if highlights are kept
   * @param highlights whether highlights are kept
   */
  public LightmapFormat(
      LightmappedScene lit,
      LightmapImageSet painted,
      HighlightLightWriter lamps,
      boolean highlights) {
    this.lit = lit;
    this.painted = painted;
    this.lamps = lamps;
    gloss =
        highlights ? SpecularMaterials.of(lit.scene(), painted.use()) : SpecularMaterials.none();
    places = OutputFileIndex.of(lit.scene());
  }

  /**
   * Returns the number of the file of each body; {@link AtlasBuilder#NO_GROUP} for bodies that need
   * no light, since they show an unlit texture.
   */
  public static int[] files(RadiosityScene scene) {
    int[] files = OutputFileIndex.of(scene).ofBodies();
    for (int i = 0; i < files.length; i++) {
      files[i] = showsByItself(scene.bodies().get(i)) ? AtlasBuilder.NO_GROUP : files[i];
    }
    return files;
  }

  private static boolean showsByItself(Body body) {
    return !body.shape().surface().lit() && body.shape().surface().texture() != null;
  }

  /** Returns the number of shapes that keep their highlights. */
  public int shining() {
    return gloss.count();
  }

  @Override
  public OutputFileIndex places() {
    return places;
  }

  @Override
  public String version(int place, String version) {
    boolean old = version.startsWith("3.");
    for (int body = 0; old && body < lit.scene().bodies().size(); body++) {
      if (places.of(body) == place && needsNew(body)) {
        return NEW;
      }
    }
    return version;
  }

  private boolean needsNew(int body) {
    return gloss.on(body) || lit.scene().bodies().get(body).transmittance() > 0;
  }

  @Override
  public void shape(LitFileWriter into, int number, ShapeInstance shape) {
    Body body = lit.scene().bodies().get(number);
    if (showsByItself(body)) {
      into.nodes().append(shape.node(), "", into);
      return;
    }
    X3dWriter out = into.out();
    out.open("Shape").def(into.nodes().define(shape.node()));
    appearance(into, number, body);
    new LightmapShapeWriter(lit, painted.use().apart(number), gloss.on(number))
        .geometry(out, number);
    out.close();
  }

  private void appearance(LitFileWriter into, int number, Body body) {
    int page = lit.atlas().layouts().get(number).page();
    String kind = kind(number, body);
    Map<String, String> known = appearances.computeIfAbsent(into.file(), key -> new HashMap<>());
    String use = known.get(kind);
    X3dWriter out = into.out();
    if (use != null) {
      out.empty("Appearance", "USE", use);
      return;
    }
    String name = into.prefix() + "Look" + (1 + known.size());
    known.put(kind, name);
    out.open("Appearance").def(name);
    if (gloss.on(number)) {
      SpecularMaterials.open(out, body);
      picture(into, page, "emissiveTexture");
      out.close();
    } else {
      if (body.transmittance() > 0) {
        out.empty("UnlitMaterial", "transparency", SpecularMaterials.text(body.transmittance()));
      }
      texture(into, number, body, page);
    }
    out.close();
  }

  /** Returns a key that two shapes of a file share if they can share an Appearance. */
  private String kind(int number, Body body) {
    String image = "";
    if (painted.use().apart(number)) {
      image = " " + number;
    }
    return "%d %s %s %s"
        .formatted(
            lit.atlas().layouts().get(number).page(),
            body.transmittance(),
            gloss.on(number) ? SpecularMaterials.fields(body) : "",
            image);
  }

  private void texture(LitFileWriter into, int number, Body body, int page) {
    if (!painted.use().apart(number)) {
      picture(into, page, "");
      return;
    }
    DiffuseTexture own = DiffuseTexture.of(body);
    into.out().open("MultiTexture", "mode", "\"MODULATE\" \"MODULATE\"");
    if (painted.brighter(number)) {
      images.append(into, own);
    } else {
      into.nodes().append(own.node().orElseThrow(), "texture", into);
    }
    picture(into, page, "");
    into.out().close();
  }

  private void picture(LitFileWriter into, int page, String container) {
    X3dWriter out = into.out();
    String name = into.prefix() + "Page" + page;
    boolean first = !files.containsKey(page);
    Path file = files.computeIfAbsent(page, key -> next(into));
    out.open("ImageTexture", first ? "DEF" : "USE", name);
    if (!container.isEmpty()) {
      out.attribute("containerField", container);
    }
    if (first) {
      out.attribute(
          "url", FieldValueFormatter.strings(UrlRelativizer.between(into.folder(), file)));
      out.attribute("repeatS", "false").attribute("repeatT", "false");
    }
    out.close();
  }

  /**
   * Returns the file of a new image beside an X3D file: named like it, with a number from the
   * second one on.
   */
  private Path next(LitFileWriter into) {
    int number = numbers.merge(into.file(), 1, Integer::sum);
    String name = into.stem() + "-light" + (number == 1 ? "" : "-" + number);
    return into.folder().resolve(name + ".png");
  }

  @Override
  public void light(LitFileWriter into, LightInstance light, String container) {
    if (gloss.count() > 0) {
      lamps.append(into, light, container);
    } else {
      into.nodes().open(light.node(), container);
      into.nodes().values(light.node(), "on", into);
      into.out().attribute("on", "false").close();
    }
  }

  @Override
  public Map<Path, byte[]> pictures() {
    List<Map.Entry<Integer, Path>> all = new ArrayList<>(files.entrySet());
    byte[][] bytes = new byte[all.size()][];
    IntStream.range(0, bytes.length)
        .parallel()
        .forEach(i -> bytes[i] = png(painted.pictures().get(all.get(i).getKey())));
    Map<Path, byte[]> made = new LinkedHashMap<>();
    for (int i = 0; i < bytes.length; i++) {
      made.put(all.get(i).getValue(), bytes[i]);
    }
    made.putAll(images.pictures());
    return made;
  }

  /**
   * Compresses an image as far as possible, or quickly if the work was cancelled and the user waits
   * for its end.
   */
  private byte[] png(LightmapImage picture) {
    return lit.complete()
        ? PngEncoder.small(picture.width(), picture.height(), picture.rgb())
        : PngEncoder.of(picture.width(), picture.height(), picture.rgb());
  }
}
