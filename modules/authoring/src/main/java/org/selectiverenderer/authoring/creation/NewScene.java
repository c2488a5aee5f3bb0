package org.selectiverenderer.authoring.creation;

import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.markup.MarkupEscaper;

/** Writes the texts of new scenes. */
public final class NewScene {
  /** The thickness of walls, floor and ceiling in metres. */
  private static final double THICK = 0.1;

  /** The height of the eyes in metres, that of the default avatarSize (X3D 4.0, 23.4.4). */
  private static final double EYES = 1.6;

  private static final int DECIMALS = 4;

  private NewScene() {}

  /**
   * Returns a scene with a viewpoint and nothing to see.
   *
   * @param title the title, usually the file's name
   */
  public static String empty(String title) {
    return scene(title, "    <Viewpoint DEF='Start' description='Start' position='0 1.6 5'/>\n");
  }

  /**
   * Returns a room around the origin, whose floor is at y = 0, with a lamp below its ceiling and a
   * viewpoint inside of it.
   *
   * @param title the title, usually the file's name
   * @param ceiling whether it has a ceiling; one sees into it from above without
   */
  public static String room(String title, RoomSize size, boolean ceiling) {
    double w = size.width();
    double d = size.depth();
    double h = size.height();
    double outerWidth = w + 2 * THICK;
    double eyes = Math.min(EYES, h * 0.6);
    StringBuilder body = new StringBuilder();
    body.append(
        """
            <NavigationInfo avatarSize='0.25 %s 0.75' headlight='false' type='"WALK" "ANY"'/>
            <Viewpoint DEF='Start' description='Start' position='0 %s %s'/>
            <PointLight DEF='Lamp' location='0 %s 0' intensity='0.8' ambientIntensity='0.4' \
        radius='%s'/>
            <Group DEF='Room'>
        """
            .formatted(
                number(eyes),
                number(eyes),
                number(d / 2 - Math.min(0.4, d / 4)),
                number(h - Math.min(0.3, h / 4)),
                number(2 * (w + d + h))));
    body.append(part("Floor", 0, -THICK / 2, 0, outerWidth, THICK, d + 2 * THICK, "0.55 0.42 0.3"));
    body.append(part("WallNorth", 0, h / 2, -(d + THICK) / 2, outerWidth, h, THICK, WALL));
    body.append(part("WallSouth", 0, h / 2, (d + THICK) / 2, outerWidth, h, THICK, WALL));
    body.append(part("WallWest", -(w + THICK) / 2, h / 2, 0, THICK, h, d, WALL));
    body.append(part("WallEast", (w + THICK) / 2, h / 2, 0, THICK, h, d, WALL));
    if (ceiling) {
      body.append(
          part("Ceiling", 0, h + THICK / 2, 0, outerWidth, THICK, d + 2 * THICK, "0.95 0.95 0.95"));
    }
    body.append("    </Group>\n");
    return scene(title, body.toString());
  }

  private static final String WALL = "0.85 0.83 0.78";

  private static String part(
      String name,
      double x,
      double y,
      double z,
      double wide,
      double high,
      double deep,
      String colour) {
    return """
              <Transform DEF='%s' translation='%s %s %s'>
                <Shape>
                  <Appearance>
                    <Material ambientIntensity='0.6' diffuseColor='%s'/>
                  </Appearance>
                  <Box size='%s %s %s'/>
                </Shape>
              </Transform>
        """
        .formatted(
            name,
            number(x),
            number(y),
            number(z),
            colour,
            number(wide),
            number(high),
            number(deep));
  }

  private static String number(double of) {
    return DecimalFormatter.rounded(of, DECIMALS);
  }

  private static String scene(String title, String body) {
    return """
        <?xml version="1.0" encoding="UTF-8"?>
        <!DOCTYPE X3D PUBLIC "ISO//Web3D//DTD X3D 4.0//EN" "https://www.web3d.org/specifications/x3d-4.0.dtd">
        <X3D profile='Immersive' version='4.0'>
          <head>
            <meta name='title' content='%s'/>
          </head>
          <Scene>
        %s  </Scene>
        </X3D>
        """
        .formatted(MarkupEscaper.text(title).replace("'", "&apos;"), body);
  }
}
