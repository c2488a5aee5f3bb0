package org.selectiverenderer.bench;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.x3d.write.FieldValueFormatter;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes scenes for growth measurements, in which one kind of thing occurs very many times and
 * everything else stays constant: a yard seen from its edge, one area to enter, ten small Switches
 * that follow the areas' schemas. The viewer walks into the yard and back in 5 s.
 */
final class GrowthSceneGenerator {
  /** The total number of triangles of a yard's objects, independent of the number of objects. */
  static final int TRIANGLES = 240_000;

  /** The number of Switches of a yard; they follow {@code Area0Schema} to {@code Area9Schema}. */
  static final int SWITCHES = 10;

  private static final String PATH =
      "t,x,y,z,yaw,pitch,roll\n0,-6,1.6,8,-20,-5,0\n2.5,0,1.6,0,0,-5,0\n5,6,1.6,8,20,-5,0\n";

  /** The side of the square yard in metres, which is in front of the viewer. */
  private static final double YARD = 20;

  /**
   * The distance between the centres of areas in metres; {@code AREA_SIZE} is the size of an area's
   * box.
   */
  private static final double AREA_STEP = 3;

  private static final String AREA_SIZE = "2 4 2";

  private final Path dir;
  private final X3dWriter out = new X3dWriter().file("Immersive", "3.3").open("Scene");
  private long triangles;
  private long bytes;

  private GrowthSceneGenerator(Path dir) {
    this.dir = dir;
    String walk = FieldValueFormatter.strings("WALK", "ANY");
    out.empty("NavigationInfo", "type", walk, "headlight", "false");
    out.empty("Background", "skyColor", "0.6 0.7 0.8");
    out.open("DirectionalLight", "direction", "-0.5 -0.75 -0.4", "intensity", "0.8");
    out.attribute("ambientIntensity", "0.5").close();
    out.empty("Viewpoint", "description", "Gate", "position", "-6 1.6 8");
    area("ProbeProx", 0, "4 4 4");
    for (int i = 0; i < SWITCHES; i++) {
      probe(i);
    }
  }

  /**
   * Writes objects of different shapes that share {@link #TRIANGLES} evenly.
   *
   * @param objects 10, 100, 1,000 or 10,000, or another number whose share can be a grid
   * @param inlined whether each object is a file of its own, or all are in the scene
   */
  static BenchScene objects(Path dir, int objects, boolean inlined) throws IOException {
    int pairs = TRIANGLES / 2 / objects;
    int rows = (int) Math.sqrt(pairs);
    while (pairs % rows != 0) {
      rows--;
    }
    return objects(dir, objects, rows, pairs / rows, inlined);
  }

  /** Writes objects with a given number of pairs of triangles up and around each object. */
  static BenchScene objects(Path dir, int objects, int rows, int columns, boolean inlined)
      throws IOException {
    GrowthSceneGenerator scene = new GrowthSceneGenerator(dir);
    Files.createDirectories(dir.resolve("objects"));
    int side = (int) Math.ceil(Math.sqrt(objects));
    for (int i = 0; i < objects; i++) {
      double step = YARD / side;
      double x = (i % side + 0.5) * step - YARD / 2;
      double z = -(i / side + 0.5) * step;
      scene.object(i, place(x, 0.6, z), rows, columns, inlined);
    }
    return scene.write();
  }

  /**
   * Writes areas side by side around the origin, each in a Transform; the path enters a few of
   * them.
   */
  static BenchScene sensors(Path dir, int sensors) throws IOException {
    GrowthSceneGenerator scene = new GrowthSceneGenerator(dir);
    int side = (int) Math.ceil(Math.sqrt(sensors));
    for (int i = 0; i < sensors; i++) {
      double x = (i % side - side / 2) * AREA_STEP;
      double z = (i / side - side / 2) * AREA_STEP;
      scene.out.open("Transform", "translation", place(x, 1, z));
      scene.area("Prox" + i, i % SWITCHES, AREA_SIZE);
      scene.out.close();
    }
    return scene.write();
  }

  private void object(int i, String place, int rows, int columns, boolean inlined)
      throws IOException {
    BenchSurface form = BenchSurface.values()[i % BenchSurface.values().length];
    SurfaceMesh mesh = SurfaceMesh.of(form, 0.7 * i, rows, columns);
    triangles += mesh.triangles().length / 3;
    String name = String.format(Locale.ROOT, "Object%05d", i);
    out.open("Transform", "translation", place);
    if (inlined) {
      String file = "objects/" + name.toLowerCase(Locale.ROOT) + ".x3d";
      bytes += write(dir.resolve(file), BenchObjectWriter.text(name, i, mesh));
      out.empty("Inline", "DEF", name, "url", FieldValueFormatter.strings(file));
    } else {
      BenchObjectWriter.write(out, name, i, mesh);
    }
    out.close();
  }

  private void area(String name, int schema, String size) {
    out.open("ProximitySensor", "DEF", name, "size", size);
    out.open("MetadataSet", "containerField", "metadata");
    BenchSwitchWriter.string(out, "enterTimeSchema", "Area" + schema + "Schema");
    BenchSwitchWriter.string(out, "exitTimeSchema", "RestSchema");
    out.close().close();
  }

  private void probe(int i) {
    out.open("Transform", "translation", place(0.3 * i - 1.5, 0.1, -3));
    out.open("Switch", "DEF", "Switch_" + i, "whichChoice", "1");
    out.open("MetadataSet", "containerField", "metadata");
    for (String schema : new String[] {"Area" + i + "Schema", "RestSchema"}) {
      out.open("MetadataSet", "containerField", "value");
      BenchSwitchWriter.string(out, "schemaBelonginess", schema);
      out.close();
    }
    out.close().open("Shape").material("diffuseColor", "0.7 0.2 0.2");
    out.empty("Box", "size", "0.2 0.2 0.2").close();
    out.empty("Group").close().close();
  }

  private BenchScene write() throws IOException {
    Files.createDirectories(dir);
    Path scene = dir.resolve("scene.x3d");
    bytes += write(scene, out.finish());
    Path path = dir.resolve("bench-path.csv");
    write(path, PATH);
    return new BenchScene(scene, path, SWITCHES, triangles, bytes);
  }

  private static String place(double x, double y, double z) {
    return DecimalFormatter.fixed(x, 3)
        + " "
        + DecimalFormatter.fixed(y, 3)
        + " "
        + DecimalFormatter.fixed(z, 3);
  }

  private static long write(Path file, String text) throws IOException {
    byte[] content = text.getBytes(StandardCharsets.UTF_8);
    Files.write(file, content);
    return content.length;
  }
}
