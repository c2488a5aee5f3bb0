package org.selectiverenderer.bench;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Generates a scene with very many enriched Switches, of which one area's schemas affect a few: the
 * cost of an activation must depend only on these few.
 *
 * <p>Child 0 of each is a small box, child 1 is empty; all show child 1 at first. Entering {@link
 * #SENSOR}, a box of 4 m around the origin, activates {@link #ENTER_SCHEMA}, leaving it {@link
 * #EXIT_SCHEMA}; the other Switches follow a thousand other schemas.
 */
public final class ManySwitchesSceneGenerator {

  /** DEF name of the sensor. */
  public static final String SENSOR = "ProbeProx";

  /** Turns the affected Switches to child 0. */
  public static final String ENTER_SCHEMA = "ProbeSchema";

  /** Turns them back to child 1. */
  public static final String EXIT_SCHEMA = "RestSchema";

  private static final int OTHER_SCHEMAS = 1000;

  private ManySwitchesSceneGenerator() {}

  /**
   * Writes {@code scene.x3d} and {@code bench-path.csv}, which walks into the area and out of it.
   *
   * @param dir created if it does not exist
   * @param switches how many Switches, at least {@code affected}
   * @param affected how many of them follow the sensor's schemas, at least 1, evenly spread
   * @throws IllegalArgumentException when the numbers do not fit
   * @throws IOException when a file cannot be written
   */
  public static BenchScene write(Path dir, int switches, int affected) throws IOException {
    if (affected < 1 || affected > switches) {
      throw new IllegalArgumentException(
          "affected must be from 1 to " + switches + ": " + affected);
    }
    Files.createDirectories(dir);
    Path scene = dir.resolve("scene.x3d");
    try (BufferedWriter out = Files.newBufferedWriter(scene)) {
      out.write(HEAD);
      int step = switches / affected;
      for (int i = 0; i < switches; i++) {
        boolean probed = i % step == 0 && i / step < affected;
        String other = Integer.toString(i % OTHER_SCHEMAS);
        writeSwitch(
            out,
            i,
            probed ? ENTER_SCHEMA : "Area" + other + "Schema",
            probed ? EXIT_SCHEMA : "Main" + other + "Schema");
      }
      out.write("  </Scene>\n</X3D>\n");
    }
    Path path = dir.resolve("bench-path.csv");
    Files.writeString(
        path, "t,x,y,z,yaw,pitch,roll\n0,0,0,6,0,0,0\n2,0,0,0,0,0,0\n4,0,0,6,0,0,0\n");
    return new BenchScene(scene, path, switches, 0, Files.size(scene));
  }

  /** The first Switch defines the two children that all share. */
  private static void writeSwitch(BufferedWriter out, int i, String enter, String exit)
      throws IOException {
    out.write("    <Switch DEF='Switch_");
    out.write(Integer.toString(i));
    out.write("' whichChoice='1'><MetadataSet containerField='metadata'>");
    writePart(out, enter);
    writePart(out, exit);
    out.write("</MetadataSet>");
    out.write(i == 0 ? CHILDREN : "<Shape USE='Small'/><Group USE='Nothing'/>");
    out.write("</Switch>\n");
  }

  private static void writePart(BufferedWriter out, String schema) throws IOException {
    out.write("<MetadataSet containerField='value'><MetadataString containerField='value'");
    out.write(" name='schemaBelonginess' value='\"");
    out.write(schema);
    out.write("\"'/></MetadataSet>");
  }

  private static final String CHILDREN =
      "<Shape DEF='Small'><Box size='0.1 0.1 0.1'/></Shape><Group DEF='Nothing'/>";

  private static final String HEAD =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <X3D profile='Immersive' version='3.3'>
        <Scene>
          <Viewpoint description='Outside' position='0 0 6'/>
          <ProximitySensor DEF='%s' size='4 4 4'>
            <MetadataSet containerField='metadata'>
              <MetadataString containerField='value' name='enterTimeSchema' value='"%s"'/>
              <MetadataString containerField='value' name='exitTimeSchema' value='"%s"'/>
            </MetadataSet>
          </ProximitySensor>
      """
          .formatted(SENSOR, ENTER_SCHEMA, EXIT_SCHEMA);
}
