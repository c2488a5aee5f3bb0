package org.selectiverenderer.models;

import static java.util.stream.Collectors.groupingBy;

import java.util.List;
import java.util.Map;
import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.models.importer.ImportedModel;
import org.selectiverenderer.models.importer.ImportedModel.ImportedCamera;
import org.selectiverenderer.models.importer.ImportedModel.ImportedLight;
import org.selectiverenderer.models.importer.ImportedModel.LightKind;
import org.selectiverenderer.models.scene.DefNames;
import org.selectiverenderer.models.scene.Numbers;
import org.selectiverenderer.models.scene.XmlText;
import org.selectiverenderer.x3d.write.X3dWriter;

/** Writes the cameras and lights of an imported model. */
final class ImportedViewWriter {
  /** The radius of lights, which Assimp knows none of, in metres. */
  private static final String UNLIMITED = "1000000";

  private final ImportedModel model;
  private final X3dWriter out;
  private final DefNames names;
  private final String file;
  private final boolean halved;
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
  }

  /** Writes what a node has. */
  void write(int node) {
    String name = XmlText.of(model.nodes().get(node).name());
    cameras.getOrDefault(node, List.of()).forEach(camera -> camera(camera, name));
    lights.getOrDefault(node, List.of()).forEach(light -> light(light, name));
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

  private void light(ImportedLight light, String name) {
    float[] color = light.color();
    double most = Math.max(color[0], Math.max(color[1], color[2]));
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
    out.attribute("intensity", Numbers.of(scale)).attribute("global", "true");
    if (light.kind() != LightKind.POINT) {
      Vector3d direction = new Vector3d(vector(light.direction()));
      boolean usable = direction.isFinite() && direction.length() > 0;
      out.attribute("direction", usable ? numbers(light.direction()) : "0 0 -1");
    }
    if (light.kind() != LightKind.DIRECTIONAL) {
      out.attribute("location", numbers(light.position())).attribute("radius", UNLIMITED);
      out.attribute("attenuation", attenuation(light.attenuation()));
    }
    if (light.kind() == LightKind.SPOT) {
      double outer = Math.min(Math.max(light.cone()[1] / 2, 1e-3), Math.PI / 2);
      double inner = Math.min(Math.max(light.cone()[0] / 2, 0), outer);
      out.attribute("cutOffAngle", Numbers.of(outer)).attribute("beamWidth", Numbers.of(inner));
    }
    out.close();
  }

  private static String attenuation(float[] given) {
    float[] factors = new float[3];
    for (int i = 0; i < 3; i++) {
      factors[i] = given[i] > 0 && Float.isFinite(given[i]) ? given[i] : 0;
    }
    return factors[0] + factors[1] + factors[2] > 0 ? numbers(factors) : "1 0 0";
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
