package org.selectiverenderer.models;

import static java.util.stream.Collectors.groupingBy;

import java.util.List;
import java.util.Map;
import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Matrix4f;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.models.importer.ImportedModel;
import org.selectiverenderer.models.importer.ImportedModel.ImportedCamera;
import org.selectiverenderer.models.importer.ImportedModel.ImportedLight;
import org.selectiverenderer.models.importer.ImportedModel.LightKind;
import org.selectiverenderer.models.scene.DefNames;
import org.selectiverenderer.models.scene.NodeTransform;
import org.selectiverenderer.models.scene.Numbers;
import org.selectiverenderer.models.scene.XmlText;
import org.selectiverenderer.x3d.write.X3dWriter;

/** Writes the cameras and lights of an imported model. */
final class ImportedViewWriter {
  /** The radius of lights, which Assimp knows none of, in metres. */
  private static final double UNLIMITED = 1e6;

  /**
   * Brightness at a metre, in multiples of white, above which a lamp is given in watts: it would
   * make all white within many metres, where no camera is exposed to it.
   */
  private static final double BRIGHT = 100;

  private final ImportedModel model;
  private final X3dWriter out;
  private final DefNames names;
  private final String file;
  private final boolean halved;
  private final boolean watts;
  private final ProblemCollector problems;
  private final Map<Integer, List<ImportedCamera>> cameras;
  private final Map<Integer, List<ImportedLight>> lights;
  private boolean told;

  ImportedViewWriter(
      ImportedModel model,
      X3dWriter out,
      DefNames names,
      ModelSource file,
      ProblemCollector problems) {
    this.model = model;
    this.out = out;
    this.names = names;
    this.file = file.name();
    halved = file.ending().equals("fbx");
    this.problems = problems;
    cameras = model.cameras().stream().collect(groupingBy(ImportedCamera::node));
    lights = model.lights().stream().collect(groupingBy(ImportedLight::node));
    watts = model.lights().stream().anyMatch(ImportedViewWriter::isInWatts);
    if (watts) {
      problems.warning(
          SourceLocation.of(file.name()),
          "its lamps are given in watts, and X3D has no exposure; they get their watts per steradian"
              + " as intensity, and fall off by the square of the distance");
    }
  }

  private static boolean isInWatts(ImportedLight light) {
    double[] factors = attenuation(light.attenuation());
    return (light.kind() == LightKind.POINT || light.kind() == LightKind.SPOT)
        && Double.isFinite(brightest(light))
        && brightest(light) > BRIGHT * (factors[0] + factors[1] + factors[2]);
  }

  private static double brightest(ImportedLight light) {
    float[] color = light.color();
    return Math.max(color[0], Math.max(color[1], color[2]));
  }

  /** Writes what a node has. */
  void write(int node) {
    String name = XmlText.of(model.nodes().get(node).name());
    cameras.getOrDefault(node, List.of()).forEach(camera -> camera(camera, name));
    List<ImportedLight> own = lights.getOrDefault(node, List.of());
    if (!own.isEmpty()) {
      own.forEach(light -> light(light, name, scale(node, 0), scale(node, -1)));
    }
  }

  /** Returns by what a node and those around it multiply lengths, up to but without another. */
  private double scale(int node, int without) {
    double scale = 1;
    for (int at = node; at > without; at = model.nodes().get(at).parent()) {
      float[] matrix = model.nodes().get(at).matrix();
      scale *= NodeTransform.averageScale(new Matrix4d(new Matrix4f().set(matrix)));
    }
    return scale;
  }

  private void camera(ImportedCamera camera, String name) {
    boolean ortho = camera.orthographicWidth() > 0;
    String def = names.unique(name + "_camera", "camera");
    out.open(ortho ? "OrthoViewpoint" : "Viewpoint", "DEF", def);
    out.attribute("description", name.isBlank() ? def : name);
    out.attribute("position", numbers(camera.position()));
    double[] turned = Numbers.axisAngle(orientation(camera.direction(), camera.up()));
    if (turned[3] != 0) {
      out.attribute("orientation", Numbers.of(turned));
    }
    double aspect = camera.aspect() > 0 && Float.isFinite(camera.aspect()) ? camera.aspect() : 1;
    if (ortho) {
      double x = Math.min(camera.orthographicWidth(), 1e6);
      double y = x / aspect;
      out.attribute("fieldOfView", Numbers.of(-x, -y, x, y));
    } else {
      // Assimp tells half of the angle of FBX, and the whole one of other formats
      double angle = camera.fieldOfView() * (halved ? 2 : 1);
      if (angle > 0 && angle < Math.PI) {
        // X3D's angle is that of the smaller side of the picture (X3D 4.0, 23.4.6)
        double small = 2 * Math.atan(Math.tan(angle / 2) / Math.max(1, aspect));
        out.attribute("fieldOfView", Numbers.of(small));
      }
    }
    out.close();
  }

  /** Returns the quaternion that turns -z to a direction, and y upwards. */
  private static double[] orientation(float[] direction, float[] up) {
    Vector3d back = new Vector3d(direction[0], direction[1], direction[2]).negate();
    Vector3d y = new Vector3d(up[0], up[1], up[2]);
    Vector3d x = y.cross(back, new Vector3d());
    if (!x.isFinite() || x.length() < 1e-9) {
      return new double[] {0, 0, 0, 1};
    }
    x.normalize();
    back.normalize();
    Quaterniond turn =
        new Quaterniond().setFromNormalized(new Matrix3d(x, back.cross(x, new Vector3d()), back));
    return new double[] {turn.x, turn.y, turn.z, turn.w};
  }

  /**
   * Writes a light. X3D measures the distance from a light in the light's own coordinates (X3D 4.0,
   * 17.2.1.4), and the model in those of its root, which may have the unit of length as its scale.
   *
   * @param inModel by what the light's coordinates are multiplied for the model's
   * @param inMetres by what they are multiplied for metres
   */
  private void light(ImportedLight light, String name, double inModel, double inMetres) {
    float[] color = light.color();
    double most = brightest(light);
    if (light.kind() == LightKind.OTHER) {
      if (!told) {
        boolean alone =
            model.lights().stream().filter(l -> l.kind() == LightKind.OTHER).count() == 1;
        problems.warning(
            SourceLocation.of(file),
            "X3D has no ambient and no area lights; light %s"
                    .formatted(ImportedSceneWriter.shown(name))
                + (alone ? " is left out" : " and others are left out"));
      }
      told = true;
      return;
    }
    if (!(most > 0) || !Double.isFinite(most)) {
      return; // it is dark
    }
    double scale = Math.max(1, most);
    out.open(
        switch (light.kind()) {
          case DIRECTIONAL -> "DirectionalLight";
          case SPOT -> "SpotLight";
          default -> "PointLight";
        },
        "DEF",
        names.unique(name + "_light", "light"),
        "color",
        Numbers.of(
            Numbers.unit(color[0] / scale),
            Numbers.unit(color[1] / scale),
            Numbers.unit(color[2] / scale)));
    boolean radiant = watts && light.kind() != LightKind.DIRECTIONAL;
    // A lamp of P watts that shines alike in all directions has P / 4 pi watts per steradian.
    double intensity = radiant ? most / (4 * Math.PI) : scale;
    out.attribute("intensity", Numbers.of(intensity)).attribute("global", "true");
    if (light.kind() != LightKind.POINT) {
      Vector3d direction = new Vector3d(vector(light.direction()));
      boolean usable = direction.isFinite() && direction.length() > 0;
      out.attribute("direction", usable ? numbers(light.direction()) : "0 0 -1");
    }
    if (light.kind() != LightKind.DIRECTIONAL) {
      double[] factors = radiant ? new double[] {0, 0, 1} : attenuation(light.attenuation());
      double unit = radiant ? inMetres : inModel;
      out.attribute("location", numbers(light.position()));
      out.attribute("radius", Numbers.of(UNLIMITED / inMetres));
      out.attribute(
          "attenuation", Numbers.of(factors[0], factors[1] * unit, factors[2] * unit * unit));
    }
    if (light.kind() == LightKind.SPOT) {
      double outer = Math.min(Math.max(light.cone()[1] / 2, 1e-3), Math.PI / 2);
      double inner = Math.min(Math.max(light.cone()[0] / 2, 0), outer);
      out.attribute("cutOffAngle", Numbers.of(outer)).attribute("beamWidth", Numbers.of(inner));
    }
    out.close();
  }

  private static double[] attenuation(float[] given) {
    double[] factors = new double[3];
    for (int i = 0; i < 3; i++) {
      factors[i] = given[i] > 0 && Float.isFinite(given[i]) ? given[i] : 0;
    }
    return factors[0] + factors[1] + factors[2] > 0 ? factors : new double[] {1, 0, 0};
  }

  private static Vector3d vector(float[] xyz) {
    return new Vector3d(xyz[0], xyz[1], xyz[2]);
  }

  private static String numbers(float[] xyz) {
    double[] finite = new double[3];
    for (int i = 0; i < 3; i++) {
      finite[i] = Float.isFinite(xyz[i]) ? xyz[i] : 0;
    }
    return Numbers.of(finite);
  }
}
