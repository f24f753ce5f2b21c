// mirror.gltf and glass.gltf for POV-Ray 3.7 (Declare=Glass=1 for the second): see homage.pov for what is alike.
#version 3.7;

global_settings {
  assumed_gamma 1
  max_trace_level 6
  adc_bailout 0.002
}

camera {
  location <0, 3.2, 4.4>
  up y
  right -x * 16 / 9
  angle 2 * degrees(atan2(tan(0.5 / 2) * 16 / 9, 1))
  look_at <0, 0.64135, 0>
}

light_source { <-5, 12, 6> rgb 0.84 * <1, 0.98, 0.94> }

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

box {
  <-9, -0.005, -9>, <9, 0.005, 9>
  pigment { rgb <0.7, 0.6, 0.5> }
  finish { ambient 0.18 diffuse 1 }
}

#include "knot.inc"
#ifdef (Glass)
  inside_vector y
  pigment { rgbt <1, 1, 1, 0.9> }
  finish { ambient 0 diffuse 0 phong 0.7 phong_size 240 reflection { 0, 0.9 fresnel on } conserve_energy }
  interior { ior 1.5 }
#else
  pigment { rgb 1 }
  finish { ambient 0 diffuse 0 phong 0.8 phong_size 180 reflection rgb 0.9 }
#end
  translate 0.7 * y
}
