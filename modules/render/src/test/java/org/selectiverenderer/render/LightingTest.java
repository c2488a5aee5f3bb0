package org.selectiverenderer.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.Parameter;
import org.junit.jupiter.params.ParameterizedClass;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.render.context.Screenshot;
import org.selectiverenderer.testing.RequiresDisplay;

/** Pixels against the equations of X3D 4.0, 17.2.2, worked out here a second time. */
@RequiresDisplay
@ParameterizedClass
@EnumSource(names = {"PIXEL", "VERTEX"})
class LightingTest {
  private static final Vector3d EYE = new Vector3d(0, 0, 10);
  private static final double DIFFUSE = 0.6;
  private static final double AMBIENT = 0.5;

  @Parameter private ShadingMode shading = ShadingMode.PIXEL;
  @AutoClose private TestImageRenderer studio;

  @BeforeEach
  void open() {
    studio = new TestImageRenderer(shading);
  }

  /** A wall in the plane z = 0 that fills the picture. */
  private static String wall(String more) {
    return """
    <Shape>
      <Appearance>
        <Material diffuseColor='0.6 0.6 0.6' ambientIntensity='0.5' %s/>
      </Appearance>
      <IndexedFaceSet coordIndex='0 1 2 3 -1' solid='false'>
        <Coordinate point='-9 -9 0 9 -9 0 9 9 0 -9 9 0'/>
      </IndexedFaceSet>
    </Shape>
    """
        .formatted(more);
  }

  private int level(String nodes, int x, int y) {
    return studio.shoot(TestScene.of(nodes)).rgb(x, y) & 0xff;
  }

  /** The place of the wall that a pixel shows. */
  private static Vector3d place(int x, int y) {
    return new Vector3d((x + 0.5) / 8 - 4, (y + 0.5) / 8 - 4, 0);
  }

  private static int level(double value) {
    return (int) Math.round(255 * Math.max(0, Math.min(1, value)));
  }

  @Test
  void aDirectionalLightShinesByTheCosine() {
    String light = "<DirectionalLight direction='-1 0 -1' intensity='0.8' ambientIntensity='0.3'/>";
    double expected = 0.3 * DIFFUSE * AMBIENT + 0.8 * DIFFUSE * Math.sqrt(0.5);
    assertThat(level(light + wall(""), 20, 20)).isCloseTo(level(expected), within(2));
  }

  @ParameterizedTest
  @CsvSource({"8, 32", "32, 32", "50, 11"})
  void aPointLightFadesWithDistance(int x, int y) {
    String light =
        "<PointLight location='1 1 2' attenuation='0.5 0.2 0.1' intensity='0.9'"
            + " ambientIntensity='0.2' radius='100'/>";
    Vector3d towards = new Vector3d(1, 1, 2).sub(place(x, y));
    double d = towards.length();
    double attenuation = 1 / Math.max(0.5 + 0.2 * d + 0.1 * d * d, 1);
    double expected = attenuation * (0.2 * DIFFUSE * AMBIENT + 0.9 * DIFFUSE * towards.z / d);
    assertThat(level(light + wall(""), x, y)).isCloseTo(level(expected), within(2));
  }

  @Test
  void beyondItsRadiusAPointLightIsDark() {
    String light = "<PointLight location='0 0 1' radius='2' ambientIntensity='1'/>";
    assertThat(level(light + wall(""), 32, 32)).isGreaterThan(100);
    assertThat(level(light + wall(""), 60, 32)).isZero();
  }

  @Test
  void aScaledPointLightReachesFartherByItsScale() {
    String light =
        "<Transform scale='2 2 2'><PointLight location='0 0 0.5' radius='2' global='true'/>"
            + "</Transform>";
    assertThat(level(light + wall(""), 59, 32)).isGreaterThan(20);
    assertThat(level(light + wall(""), 63, 32)).isZero();
  }

  @ParameterizedTest
  @CsvSource({"32, 32", "44, 32", "48, 32", "60, 32"})
  void aSpotLightFallsOffBetweenBeamWidthAndCutOff(int x, int y) {
    String light =
        "<SpotLight location='0 0 3' direction='0 0 -1' beamWidth='0.3' cutOffAngle='0.7'/>";
    Vector3d towards = new Vector3d(0, 0, 3).sub(place(x, y));
    double cosine = towards.z / towards.length();
    double angle = Math.acos(cosine);
    double spot = Math.max(0, Math.min(1, (angle - 0.7) / (0.3 - 0.7)));
    assertThat(level(light + wall(""), x, y)).isCloseTo(level(spot * DIFFUSE * cosine), within(2));
  }

  @ParameterizedTest
  @CsvSource({"32, 32", "42, 36", "56, 20"})
  void theHighlightFollowsTheHalfVector(int x, int y) {
    String light = "<PointLight location='2 0 4' radius='100'/>";
    Vector3d l = new Vector3d(2, 0, 4).sub(place(x, y)).normalize();
    Vector3d v = new Vector3d(EYE).sub(place(x, y)).normalize();
    Vector3d h = new Vector3d(l).add(v).normalize();
    double expected = DIFFUSE * l.z + 0.4 * Math.pow(h.z, 0.25 * 128);
    String shiny = wall("specularColor='0.4 0.4 0.4' shininess='0.25'");
    assertThat(level(light + shiny, x, y)).isCloseTo(level(expected), within(2));
  }

  @Test
  void emissionIsAddedAndLightsAddUp() {
    String lights =
        "<DirectionalLight direction='0 0 -1' intensity='0.3'/>"
            + "<DirectionalLight direction='0 0 -1' intensity='0.5'/>";
    assertThat(level(lights + wall("emissiveColor='0.1 0.1 0.1'"), 20, 20))
        .isCloseTo(level(0.1 + 0.8 * DIFFUSE), within(1));
  }

  @Test
  void theBackOfATwoSidedFaceIsLitFromItsOwnSide() {
    String light = "<DirectionalLight direction='0 0 -1'/>";
    String turned = "<Transform rotation='0 1 0 3.14159265'>" + wall("") + "</Transform>";
    assertThat(level(light + turned, 20, 20)).isCloseTo(level(DIFFUSE), within(1));
    String behind = "<DirectionalLight direction='0 0 1'/>";
    assertThat(level(behind + wall(""), 20, 20)).isZero();
  }

  @Test
  void aLightThatIsNotGlobalStaysInItsGroup() {
    String light = "<DirectionalLight direction='0 0 -1' global='false'/>";
    assertThat(level("<Group>" + light + wall("") + "</Group>", 20, 20)).isGreaterThan(100);
    assertThat(level("<Group>" + light + "</Group>" + wall(""), 20, 20)).isZero();
    String everywhere = light.replace("false", "true");
    assertThat(level("<Group>" + everywhere + "</Group>" + wall(""), 20, 20)).isGreaterThan(100);
  }

  @Test
  void aLightThatIsSwitchedOnIsSeenAtTheNextFrame() {
    TestScene scene =
        TestScene.of("<DirectionalLight DEF='L' direction='0 0 -1' on='false'/>" + wall(""));
    assertThat(studio.shoot(scene).rgb(20, 20)).isZero();
    scene.set("L", "on", true);
    assertThat(studio.shoot(scene).rgb(20, 20) & 0xff).isCloseTo(level(DIFFUSE), within(1));
  }

  @Test
  void theHeadlightShinesAlongTheLineOfSight() {
    Camera camera =
        TestImageRenderer.perspective(new Matrix4d().translation(0, 0, -5).rotateY(0.5));
    Screenshot shot = studio.shoot(TestScene.of(wall("")), camera, Background.BLACK, true, 0);
    assertThat(shot.rgb(32, 32) & 0xff).isCloseTo(level(DIFFUSE * Math.cos(0.5)), within(2));
  }

  @Test
  void aSphereIsBrightestTowardsTheLight() {
    Screenshot shot =
        studio.shoot(
            TestScene.of(
                "<DirectionalLight direction='-1 -1 -1'/>"
                    + "<Shape><Appearance><Material/></Appearance><Sphere radius='3'/></Shape>"));
    int brightestX = 0;
    int brightestY = 0;
    int most = -1;
    for (int y = 0; y < 64; y++) {
      for (int x = 0; x < 64; x++) {
        if ((shot.rgb(x, y) & 0xff) > most) {
          most = shot.rgb(x, y) & 0xff;
          brightestX = x;
          brightestY = y;
        }
      }
    }
    double expected = 32 + 8 * 3 / Math.sqrt(3);
    assertThat((double) brightestX).isCloseTo(expected, within(4.0));
    assertThat((double) brightestY).isCloseTo(expected, within(4.0));
    assertThat(most).isCloseTo(level(0.8), within(2));
  }
}
