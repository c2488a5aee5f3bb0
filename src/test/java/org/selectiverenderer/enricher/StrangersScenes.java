package org.selectiverenderer.enricher;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/**
 * Writes scenes as other programs and authors write them: without names, in VRML97, of files with
 * prototypes. All have a floor of 20 m at height 0 and furniture in a row along x at z = 0.
 */
final class StrangersScenes {
  private static final int RINGS = 40;

  private StrangersScenes() {}

  /** The attributes or fields of a sphere as a mesh: its points, or the faces between them. */
  private static String points(int rings, double radius) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i <= rings; i++) {
      for (int j = 0; j < rings; j++) {
        double tilt = Math.PI * i / rings;
        double turn = 2 * Math.PI * j / rings;
        text.append(
            String.format(
                Locale.ROOT,
                "%.5f %.5f %.5f, ",
                radius * Math.sin(tilt) * Math.cos(turn),
                radius * Math.cos(tilt) + radius,
                radius * Math.sin(tilt) * Math.sin(turn)));
      }
    }
    return text.toString();
  }

  private static String faces(int rings) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < rings; i++) {
      for (int j = 0; j < rings; j++) {
        int next = (j + 1) % rings;
        int a = i * rings + j;
        int b = i * rings + next;
        // At the poles all points of a ring are one: only one triangle of the four corners is left.
        if (i > 0) {
          text.append("%d %d %d -1 ".formatted(a, b, b + rings));
        }
        if (i < rings - 1) {
          text.append("%d %d %d -1 ".formatted(a, b + rings, a + rings));
        }
      }
    }
    return text.toString();
  }

  private static String mesh() {
    return "<IndexedFaceSet solid='false' coordIndex='%s'><Coordinate point='%s'/></IndexedFaceSet>"
        .formatted(faces(RINGS), points(RINGS, 0.4));
  }

  private static String shape(String colour) {
    return """
        <Shape><Appearance><Material diffuseColor='%s'/></Appearance>
        %s
        </Shape>
        """
        .formatted(colour, mesh());
  }

  private static String document(String nodes) {
    return """
        <?xml version="1.0" encoding="UTF-8"?>
        <X3D profile='Immersive' version='3.3'>
        <Scene>
        <Viewpoint position='0 2.2 7' orientation='1 0 0 -0.2' description='Entry'/>
        <Transform translation='0 -0.1 0'><Shape><Appearance><Material diffuseColor='.8 .8 .7'/>
        </Appearance><Box size='20 0.2 20'/></Shape></Transform>
        %s</Scene>
        </X3D>
        """
        .formatted(nodes);
  }

  /** An office of a modeller: no names, one mesh for each piece, more than 1 MB. */
  static Path office(Path folder) throws IOException {
    StringBuilder nodes = new StringBuilder();
    for (int i = 0; i < 14; i++) {
      nodes.append(
          "<Transform translation='%d 0 %d'>%s</Transform>\n"
              .formatted(i % 5 * 2 - 4, -(i / 5) * 2, shape(i % 2 == 0 ? ".7 .3 .2" : ".2 .4 .7")));
    }
    return Files.writeString(folder.resolve("office.x3d"), document(nodes.toString()));
  }

  /** A house in VRML97, whose pieces share their appearances by DEF and USE. */
  static Path vrml(Path folder) throws IOException {
    StringBuilder text =
        new StringBuilder(
            """
            #VRML V2.0 utf8
            Viewpoint { position 0 2.2 7 orientation 1 0 0 -0.2 description "Entry" }
            Transform { translation 0 -0.1 0 children Shape {
              appearance DEF Wood Appearance { material Material { diffuseColor .6 .4 .2 } }
              geometry Box { size 20 0.2 20 } } }
            """);
    String[] names = {"Table", "Stool", "Basket", "Lamp"};
    for (int i = 0; i < names.length; i++) {
      String appearance =
          i == 0
              ? "DEF Cloth Appearance { material Material { diffuseColor .2 .5 .3 } }"
              : i % 2 == 0 ? "USE Cloth" : "USE Wood";
      text.append(
          """
          DEF %s Transform { translation %d 0 0 children Shape { appearance %s
            geometry IndexedFaceSet { solid FALSE coord Coordinate { point [ %s ] } coordIndex [ %s ] } } }
          """
              .formatted(names[i], i * 2 - 4, appearance, points(RINGS, 0.4), faces(RINGS)));
    }
    return Files.writeString(folder.resolve("house.wrl"), text.toString());
  }

  /** A room with chairs of its own prototype and of another file's. */
  static Path room(Path folder) throws IOException {
    String proto =
        "<ProtoDeclare name='%s'><ProtoInterface><field accessType='inputOutput' type='SFVec3f'"
            + " name='at' value='0 0 0'/></ProtoInterface>\n<ProtoBody><Transform>"
            + "<IS><connect nodeField='translation' protoField='at'/></IS>%s</Transform>"
            + "</ProtoBody></ProtoDeclare>\n";
    Files.writeString(
        folder.resolve("chairs.x3d"),
        """
        <X3D profile='Immersive' version='3.3'>
        <Scene>
        """
            + proto.formatted("Armchair", shape(".3 .3 .6"))
            + "</Scene>\n</X3D>\n");
    String nodes =
        proto.formatted("Chair", shape(".6 .3 .3"))
            + """
            <ExternProtoDeclare name='Armchair' url='"chairs.x3d#Armchair"'>
            <field accessType='inputOutput' type='SFVec3f' name='at'/></ExternProtoDeclare>
            <ProtoInstance DEF='Chair1' name='Chair'><fieldValue name='at' value='-4 0 0'/></ProtoInstance>
            <ProtoInstance DEF='Armchair1' name='Armchair'><fieldValue name='at' value='-2 0 0'/>
            </ProtoInstance>
            <Transform DEF='Pouffe' translation='0 0 0'>%s</Transform>
            <Transform DEF='Globe' translation='2 0 0'>%s</Transform>
            """
                .formatted(shape(".5 .5 .2"), shape(".2 .6 .6"));
    Path room = Files.writeString(folder.resolve("living.x3d"), document(nodes));
    Files.writeString(
        folder.resolve("house.x3d"),
        """
        <X3D profile='Immersive' version='3.3'>
        <Scene>
        <Inline url='"living.x3d"'/>
        </Scene>
        </X3D>
        """);
    return room;
  }

  /** A vase as a GLB of glTF 2.0, for an import. */
  static Path glb(Path folder) throws IOException {
    int rings = 24;
    String[] coordinates = points(rings, 0.3).replace(",", "").trim().split("\\s+");
    String[] corners = faces(rings).replace("-1", "").trim().split("\\s+");
    ByteBuffer data =
        ByteBuffer.allocate(coordinates.length * 4 + corners.length * 4)
            .order(ByteOrder.LITTLE_ENDIAN);
    for (String each : coordinates) {
      data.putFloat(Float.parseFloat(each));
    }
    for (String each : corners) {
      data.putInt(Integer.parseInt(each));
    }
    StringBuilder json =
        new StringBuilder(
            """
            {"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
            "nodes":[{"name":"Vase","mesh":0}],
            "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
            "materials":[{"doubleSided":true,"pbrMetallicRoughness":{"baseColorFactor":[0.8,0.6,0.2,1]}}],
            "buffers":[{"byteLength":%d}],
            "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":%d},
            {"buffer":0,"byteOffset":%d,"byteLength":%d}],
            "accessors":[{"bufferView":0,"componentType":5126,"count":%d,"type":"VEC3",
            "min":[-0.3,0,-0.3],"max":[0.3,0.6,0.3]},
            {"bufferView":1,"componentType":5125,"count":%d,"type":"SCALAR"}]}"""
                .formatted(
                    data.capacity(),
                    coordinates.length * 4,
                    coordinates.length * 4,
                    corners.length * 4,
                    coordinates.length / 3,
                    corners.length));
    while (json.length() % 4 != 0) {
      json.append(' ');
    }
    byte[] head = json.toString().getBytes(UTF_8);
    ByteBuffer all =
        ByteBuffer.allocate(28 + head.length + data.capacity()).order(ByteOrder.LITTLE_ENDIAN);
    all.putInt(0x46546c67).putInt(2).putInt(all.capacity());
    all.putInt(head.length).putInt(0x4e4f534a).put(head);
    all.putInt(data.capacity()).putInt(0x004e4942).put(data.array());
    return Files.write(Files.createDirectories(folder).resolve("vase.glb"), all.array());
  }

  /** A walk from afar to the first piece, which stands at (-4, 0, 0), and back. */
  static Path walk(Path folder) throws IOException {
    return Files.writeString(
        folder.resolve("walk.csv"),
        """
        t,x,y,z,yaw,pitch,roll
        0,8,1,8,0,0,0
        2,8,1,8,0,0,0
        6,-4,1,0.9,0,0,0
        8,-4,1,0.9,0,0,0
        12,8,1,8,0,0,0
        """);
  }
}
