// assets/scenes/homage.gltf for POV-Ray 3.7: same geometry, camera, lamp, materials and depth. Right-handed, by
// the negative `right` vector; colours are linear.
#version 3.7;

global_settings {
  assumed_gamma 1
  max_trace_level 6 // counts the eye ray, which Eyeray calls depth 0
  adc_bailout 0.002 // Eyeray's cutoff
}

camera {
  location <0.2, 2.9, 7.4>
  up y
  right -x * 16 / 9
  angle 2 * degrees(atan2(tan(0.532325 / 2) * 16 / 9, 1)) // horizontal, from the vertical one in radians
  look_at <-0.1, 1.5, 0>
}

light_source { <-5, 12, 6> rgb 0.84 * <1, 0.98, 0.94> }

// From the horizon to zenith and nadir by the root of |y|, in steps of equal change.
#declare Zenith = rgb <0.05, 0.2, 0.62>;
#declare Horizon = rgb <0.5, 0.72, 0.94>;
#declare Nadir = rgb <0.26, 0.36, 0.52>;
#declare Steps = 8;
sky_sphere {
  pigment {
    gradient y
    color_map {
      #for (I, -Steps, Steps)
        #local Share = abs(I) / Steps;
        [0.5 + 0.5 * Share * I / Steps (1 - Share) * Horizon + Share * (I < 0 ? Nadir : Zenith)]
      #end
    }
    scale 2
    translate -y
  }
}

// A checkerboard is a solid pattern: the floor cuts it half a cell up.
polygon {
  5, <-9, 0, -17>, <9, 0, -17>, <9, 0, 9>, <-9, 0, 9>, <-9, 0, -17>
  pigment { checker rgb <0.96, 0.8, 0.08> rgb <0.82, 0.05, 0.03> translate -0.5 * y }
  finish { ambient 0.9 * 0.18 diffuse 0.9 }
}

// A glass ball with air inside. Its reflectivity and transmission add up to 0.9, which Fresnel's equations divide;
// shadow rays go through it with 0.9, in Eyeray with the transmission alone, 0.81: so its shadow is a little lighter.
difference {
  sphere {
    <-0.75, 1.95, 1.2>, 1
    pigment { rgbt <1, 1, 1, 0.9> }
    finish { ambient 0 diffuse 0 phong 0.7 phong_size 240 reflection { 0, 0.9 fresnel on } conserve_energy }
  }
  sphere {
    <-0.75, 1.95, 1.2>, 0.92
    pigment { rgbt <1, 1, 1, 1> }
    finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } conserve_energy }
  }
  interior { ior 1.49 }
}

sphere {
  <1.05, 1.3, -1.4>, 1.2
  pigment { rgb 1 }
  finish { ambient 0.04 * 0.18 diffuse 0.04 phong 0.8 phong_size 180 reflection rgb <0.9, 0.9, 0.91> }
}
