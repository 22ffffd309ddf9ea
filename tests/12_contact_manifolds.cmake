# The program as a reader runs it.
foreach(scene across stack overhang rocking rolling bullet pile)
  add_program_test(ch12 12_contact_manifolds "runs scene ${scene}" --headless --scene ${scene} --steps 200
                   --method sweeps,exact,one_point,no_names --csv -)
endforeach()
add_program_test(ch12 12_contact_manifolds "runs scene chain" --headless --scene chain --steps 200 --method sweeps,exact --csv -)
